// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A program that flags of hardening leave their marks in: a buffer on the stack, filled by a size
// that is known when it runs.
#include <cstdio>
#include <cstring>

int main(int argc, char** argv) {
  char buffer[64] = {};
  const std::size_t size = std::strlen(argv[argc - 1]);
  std::memcpy(buffer, argv[argc - 1], size);
  std::printf("%s\n", buffer);
  return 0;
}
