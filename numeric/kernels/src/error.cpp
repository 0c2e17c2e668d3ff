// SPDX-License-Identifier: 0BSD
// Text for one-line messages.
#include "twoscale/kernels/error.hpp"

namespace twoscale::kernels {

std::string quoted(std::string_view text, std::size_t max_length) {
  static constexpr char hex[] = "0123456789abcdef";
  std::string out = "'";
  for (std::size_t i = 0; i < text.size() && i < max_length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte >= 0x20 && byte < 0x7f) {
      out += text[i];
    } else {
      out += "\\x";
      out += hex[byte >> 4];
      out += hex[byte & 15];
    }
  }
  if (text.size() > max_length) out += "...";
  return out + "'";
}

}  // namespace twoscale::kernels
