// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. The small part of JSON that a certificate uses: strings, small integers, arrays,
// objects.
#pragma once

#include "twoscale/check/meter.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace twoscale::check {

struct Value {
  enum class Kind { string, integer, array, object };
  Kind kind = Kind::array;
  std::string text;               ///< string: its characters, printable ASCII
  long number = 0;                ///< integer: |number| <= 10^6
  std::vector<Value> items;       ///< array: elements; object: the values, in the order of `keys`
  std::vector<std::string> keys;  ///< object: member names in the order of the text
};

/// Parses a JSON document. Refuses (Malformed): any byte outside printable ASCII and line ends, escapes other than \"
/// and
/// \\, floating-point numbers, integers beyond 10^6, true/false/null, empty objects, more than 16 levels.
Value parse_json(std::string_view text);

/// The one accepted spelling: one space of indent a level, one element or member a line, `[]`, `"key": value`, final
/// newline.
std::string canonical_json(const Value& value);

/// Reads the members of an object in their prescribed order; `where` names the object in messages.
class Fields {
 public:
  Fields(const Value& object, std::string where);
  /// The next member, which must be called `key`.
  const Value& take(std::string_view key);
  /// Is this the key of the next member?
  bool next_is(std::string_view key) const { return next_ < object_.keys.size() && object_.keys[next_] == key; }
  /// Is the next member called `key`, a string, and equal to `text`?
  bool next_is_text(std::string_view key, std::string_view text) const {
    return next_is(key) && object_.items[next_].kind == Value::Kind::string && object_.items[next_].text == text;
  }
  /// Every member has been taken.
  void done() const;
  std::string path(std::string_view key) const;

  const std::string& take_string(std::string_view key);
  long take_integer(std::string_view key, long low, long high);
  const std::vector<Value>& take_array(std::string_view key);

 private:
  const Value& object_;
  std::string where_;
  std::size_t next_ = 0;
};

const std::string& as_string(const Value& value, const std::string& where);
long as_integer(const Value& value, long low, long high, const std::string& where);
const std::vector<Value>& as_array(const Value& value, const std::string& where);

}  // namespace twoscale::check
