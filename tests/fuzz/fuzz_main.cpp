// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// libFuzzer's way into one target, named at compile time: SUREFOOT_FUZZ_TARGET="pcd".
#include <cstdlib>
#include <string_view>

#include "fuzz/targets.hpp"

namespace {

surefoot::fuzz::Target target() {
  for (const surefoot::fuzz::Target& one : surefoot::fuzz::targets()) {
    if (std::string_view(one.name) == SUREFOOT_FUZZ_TARGET) {
      return one;
    }
  }
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const surefoot::fuzz::Target chosen = target();
  chosen.read({reinterpret_cast<const std::byte*>(data), size});
  return 0;
}
