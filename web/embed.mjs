// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// node embed.mjs PAGE OUT HEADER NAMESPACE FUNCTION: the page as a C++ function of that name, which
// the header declares; "report/page.hpp", say.
import { readFile, writeFile } from "node:fs/promises";

const [input, output, header, namespace, name] = process.argv.slice(2);

/** As the inside of a string literal; octal escapes end after three digits, whatever follows. */
function literal(bytes) {
  let text = "";
  for (const byte of bytes) {
    const plain = byte >= 0x20 && byte < 0x7f && !'"\\?'.includes(String.fromCharCode(byte));
    text += plain ? String.fromCharCode(byte) : `\\${byte.toString(8).padStart(3, "0")}`;
  }
  return text;
}

const page = await readFile(input);
const lines = [];
for (let at = 0; at < page.length; at += 4096) {
  lines.push(`    "${literal(page.subarray(at, at + 4096))}"`);
}
await writeFile(
  output,
  `// Made by web/embed.mjs from web/src.
#include "${header}"

namespace surefoot::${namespace} {

std::string_view ${name}() {
  static constexpr char kPage[] =
${lines.join("\n")};
  return {kPage, sizeof(kPage) - 1};
}

}  // namespace surefoot::${namespace}
`,
);
