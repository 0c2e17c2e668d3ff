// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Strict mini JSON: parser, canonical writer, reader of prescribed members.
#include "twoscale/check/json.hpp"

namespace twoscale::check {
namespace {

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Value document() {
    Value value = element(1);
    skip_blanks();
    if (at_ != text_.size()) fail("text after the end of the document");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Malformed("JSON, byte " + std::to_string(at_) + ": " + what);
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_blanks() {
    while (peek() == ' ' || peek() == '\n') ++at_;
  }
  void expect(char c) {
    skip_blanks();
    if (peek() != c || at_ >= text_.size()) fail(std::string("expected '") + c + "'");
    ++at_;
  }
  bool accept(char c) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  std::string string() {
    expect('"');
    std::string result;
    while (true) {
      if (at_ >= text_.size()) fail("unterminated string");
      char c = text_[at_++];
      if (c == '"') return result;
      if (c == '\\') {
        c = peek();
        if (c != '"' && c != '\\') fail("escape sequence");
        ++at_;
      } else if (c < 0x20 || c > 0x7e) {
        fail("a character that is not printable ASCII");
      }
      result.push_back(c);
    }
  }

  long integer() {
    const bool negative = accept('-');
    const std::size_t start = at_;
    long result = 0;
    for (; peek() >= '0' && peek() <= '9'; ++at_) {
      result = 10 * result + (peek() - '0');
      if (result > limits::index) fail("an integer beyond 1000000");
    }
    const std::size_t length = at_ - start;
    if (length == 0) fail("expected a string, an integer, an array or an object");
    if (text_[start] == '0' && (length > 1 || negative)) fail("an integer that is not in canonical form");
    return negative ? -result : result;
  }

  Value element(int depth) {
    if (depth > limits::depth) fail("nested more than " + std::to_string(limits::depth) + " deep");
    if (++values_ > limits::json_values) fail("more than " + std::to_string(limits::json_values) + " values");
    skip_blanks();
    Value value;
    if (peek() == '"') {
      value.kind = Value::Kind::string;
      value.text = string();
    } else if (accept('[')) {
      value.kind = Value::Kind::array;
      if (accept(']')) return value;
      do value.items.push_back(element(depth + 1));
      while (accept(','));
      expect(']');
    } else if (accept('{')) {
      value.kind = Value::Kind::object;
      do {
        value.keys.push_back(string());
        expect(':');
        value.items.push_back(element(depth + 1));
      } while (accept(','));
      expect('}');
    } else {
      value.kind = Value::Kind::integer;
      value.number = integer();
    }
    return value;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t values_ = 0;
};

void write_string(std::string& out, const std::string& text) {
  out.push_back('"');
  for (const char c : text) {
    if (c == '"' || c == '\\') out.push_back('\\');
    out.push_back(c);
  }
  out.push_back('"');
}

void write(std::string& out, const Value& value, std::size_t depth) {
  switch (value.kind) {
    case Value::Kind::string: write_string(out, value.text); return;
    case Value::Kind::integer: out += std::to_string(value.number); return;
    case Value::Kind::array:
    case Value::Kind::object: break;
  }
  const bool object = value.kind == Value::Kind::object;
  if (value.items.empty()) {
    out += object ? "{}" : "[]";
    return;
  }
  out.push_back(object ? '{' : '[');
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    out += i == 0 ? "\n" : ",\n";
    out.append(depth + 1, ' ');
    if (object) {
      write_string(out, value.keys[i]);
      out += ": ";
    }
    write(out, value.items[i], depth + 1);
  }
  out.push_back('\n');
  out.append(depth, ' ');
  out.push_back(object ? '}' : ']');
}

}  // namespace

Value parse_json(std::string_view text) { return Parser(text).document(); }

std::string canonical_json(const Value& value) {
  std::string out;
  write(out, value, 0);
  out.push_back('\n');
  return out;
}

Fields::Fields(const Value& object, std::string where) : object_(object), where_(std::move(where)) {
  if (object.kind != Value::Kind::object) throw Malformed(where_ + ": an object is expected");
}

std::string Fields::path(std::string_view key) const {
  return where_.empty() ? std::string(key) : where_ + "." + std::string(key);
}

const Value& Fields::take(std::string_view key) {
  if (!next_is(key)) {
    const std::string found = next_ < object_.keys.size() ? "\"" + object_.keys[next_].substr(0, 40) + "\"" : "the end";
    throw Malformed(path(key) + ": expected as the next member, found " + found);
  }
  return object_.items[next_++];
}

void Fields::done() const {
  if (next_ != object_.keys.size()) throw Malformed(path(object_.keys[next_].substr(0, 40)) + ": unexpected member");
}

const std::string& Fields::take_string(std::string_view key) { return as_string(take(key), path(key)); }

long Fields::take_integer(std::string_view key, long low, long high) {
  return as_integer(take(key), low, high, path(key));
}

const std::vector<Value>& Fields::take_array(std::string_view key) { return as_array(take(key), path(key)); }

const std::string& as_string(const Value& value, const std::string& where) {
  if (value.kind != Value::Kind::string) throw Malformed(where + ": a string is expected");
  return value.text;
}

long as_integer(const Value& value, long low, long high, const std::string& where) {
  if (value.kind != Value::Kind::integer || value.number < low || value.number > high) {
    throw Malformed(where + ": an integer from " + std::to_string(low) + " to " + std::to_string(high) +
                    " is expected");
  }
  return value.number;
}

const std::vector<Value>& as_array(const Value& value, const std::string& where) {
  if (value.kind != Value::Kind::array) throw Malformed(where + ": an array is expected");
  return value.items;
}

}  // namespace twoscale::check
