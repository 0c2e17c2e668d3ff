// SPDX-License-Identifier: GPL-3.0-or-later
// The second direction of a grid, said once for refine and plot surface: the scheme and the options of the command
// belong to u (from row to row), those that begin with --tensor to v (along a row).
#pragma once

#include <optional>
#include <string>

#include "session.hpp"
#include "twoscale/kernels/grid_io.hpp"
#include "twoscale/lowering/refine_grid.hpp"

namespace twoscale::cli {

struct TensorOptions {
  std::string scheme;  // empty: that of u
  Values values;       // none: those of u, when the scheme is that of u
  std::optional<int> levels;
  std::string open;
  bool closed = false;

  bool any() const;
};

// --tensor SCHEME2 [--tensor-v0 E|--tensor-t E|--tensor-at …] [--tensor-levels K] [--tensor-closed|--tensor-open RULE].
void add_tensor(CLI::App* command, TensorOptions& options);

// What the options of the command say about u.
struct MainDirection {
  std::string scheme;
  const Values& values;
  unsigned levels;
  std::string open;  // empty: not said
  bool closed;       // said
};

struct Directions {
  lowering::Direction u, v;
  kernels::Closings closings() const;
};

// Directions for a grid. What is not said about v is as for u; what is not said at all is closed, and refused for a
// mesh that is open there. Throws Error(bad_input).
Directions directions(const MainDirection& u, const TensorOptions& v, const kernels::PointGrid& grid);

// A rule of --open or of a description: given, linear or space. `option` is what the message begins with.
kernels::Boundary open_rule(const std::string& option, const std::string& text);

}  // namespace twoscale::cli
