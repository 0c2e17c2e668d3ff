// SPDX-License-Identifier: GPL-3.0-or-later
// What the recipes of the catalogue share: reading keys, canonical names, and the list of recipe files.
//
// One file a family of schemes. Each has one function that appends its entries to the catalogue; catalog.cpp calls it.
#pragma once

#include <string>
#include <vector>

#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/scheme_file.hpp"

namespace twoscale::families {

constexpr long largest_l = 128;

// The entry of the catalogue. Throws Error(bad_input) naming an unknown id, a key that is unknown or missing.
const CatalogEntry& entry_of(const SchemeName& name);
// The value of a key that is an integer between two bounds. Throws Error(bad_input) naming the text.
long integer_key(const SchemeName& name, const std::string& key, long least, long greatest);
// The key `arity`, 2 if absent.
int arity_key(const SchemeName& name);
// The same scheme has one name: the space in its canonical order, arity 2 not said.
std::string canonical_id(SchemeName name, const Space& space);
// {1, ..., x^{order-1}}.
Space polynomials(unsigned order);

// Each appends the entries of its file.
void add_bsplines(std::vector<CatalogEntry>& list);
void add_interpolating(std::vector<CatalogEntry>& list);
void add_quasi_splines(std::vector<CatalogEntry>& list);
void add_mask(std::vector<CatalogEntry>& list);
void add_hermite(std::vector<CatalogEntry>& list);
void add_files(std::vector<CatalogEntry>& list);

// The scheme of a file with the values of constant parameters that `name` has as keys; its id is the file's name with
// these keys. Throws Error(bad_input) naming a key that is none, or a value that is not rational or outside its domain.
Scheme scheme_of_file(const SchemeFile& file, SchemeName name);
void add_nuli(std::vector<CatalogEntry>& list);

}  // namespace twoscale::families
