// SPDX-License-Identifier: GPL-3.0-or-later
// Room: command line. The program `twoscale-check FILE`: checks a certificate; links the checker and nothing else.
#include "twoscale/check/check.hpp"
#include "twoscale/check/meter.hpp"

#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#ifndef TWOSCALE_VERSION
#define TWOSCALE_VERSION "0.1.0"
#endif

namespace {

constexpr const char* usage =
    "twoscale-check FILE\n"
    "\n"
    "Checks a twoscale certificate (docs/certificates.md) without computer algebra and without trusting the program "
    "that\n"
    "wrote it. Prints one line for each claim, with the theorem that turns the verified algebra into the claim.\n"
    "\n"
    "  --help     this text\n"
    "  --version  the version of the program and of the format\n"
    "\n"
    "Exit status: 0 every claim holds; 1 a claim does not hold (it is named, with the reason); 2 the file is not a\n"
    "certificate or exceeds the limits of the format, or the command line is wrong; 4 the file could not be read.\n";

int complain(int status, const std::string& message) {
  std::cerr << "twoscale-check: " << message << '\n';
  return status;
}

int check_file(const std::string& path) {
  using namespace twoscale::check;
  std::ifstream in(path, std::ios::binary);
  if (!in) return complain(4, path + ": cannot be read");
  std::string text;
  char block[1 << 16];
  while (text.size() <= limits::file_bytes) {  // one byte too many is enough to refuse the file
    in.read(block, sizeof block);
    text.append(block, static_cast<std::size_t>(in.gcount()));
    if (!in) break;
  }
  if (in.bad()) return complain(4, path + ": cannot be read");

  const Report report = check_text(text);
  for (const std::string& line : report.lines) std::cout << line << '\n';
  std::cout.flush();
  if (!std::cout) return complain(4, "the output could not be written");
  if (report.status == Report::malformed) return complain(2, path + ": " + report.message);
  return report.status == Report::valid ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string argument = argc == 2 ? argv[1] : "";
    if (argument == "--help" || argument == "--version") {
      std::cout << (argument == "--help" ? usage : "twoscale-check " TWOSCALE_VERSION " (certificate format 1)\n");
      std::cout.flush();
      return std::cout ? 0 : complain(4, "the output could not be written");
    }
    if (argc != 2 || argument.empty() || argument.front() == '-') return complain(2, "usage: twoscale-check FILE");
    return check_file(argument);
  } catch (const std::exception& error) {
    return complain(4, error.what());
  }
}
