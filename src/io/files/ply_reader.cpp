// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/ply_reader.hpp"

#include <cstring>
#include <string>

#include "io/ascii_values.hpp"
#include "io/files/ply_header.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

using Bytes = std::span<const std::byte>;

[[noreturn]] void fail_short(const PlyElement& element, std::size_t found) {
  throw ReadError("PLY: the data end after " + std::to_string(found) + " of " +
                  std::to_string(element.count) + " " + in_quotes(element.name) + " elements");
}

// Columns over points of `scalar_step()` bytes that begin at `first`.
void add_columns(const PlyElement& element, const std::byte* first, bool swapped,
                 PointTable& table) {
  table.size = element.count;
  const std::size_t step = element.scalar_step();
  for (const PlyProperty& property : element.properties) {
    if (!property.list_count_type) {
      table.columns.push_back({property.name, property.type, first, step, swapped});
      first += element.count > 0 ? size_of(property.type) : 0;  // no points may have no memory
    }
  }
}

// Reads binary elements from front to back.
class BinaryElements {
 public:
  BinaryElements(Bytes data, bool swapped) : data_(data), swapped_(swapped) {}

  void skip(const PlyElement& element) {
    if (element.has_lists()) {
      walk(element, nullptr);
    } else {
      take_fixed(element);
    }
  }

  void read(const PlyElement& element, PointTable& table) {
    if (element.has_lists()) {
      walk(element, &table.storage);
      add_columns(element, table.storage.data(), swapped_, table);
    } else {
      add_columns(element, take_fixed(element), swapped_, table);
    }
  }

 private:
  const std::byte* take_fixed(const PlyElement& element) {
    const std::byte* first = data_.data();
    const std::size_t step = element.scalar_step();
    if (step > 0 && element.count > data_.size() / step) {
      fail_short(element, data_.size() / step);
    }
    data_ = data_.subspan(element.count * step);
    return first;
  }

  // Element by element, as lists have any length; numbers go to `scalars` if it is given. Each
  // element takes a byte at least, so that the loop ends with the data.
  void walk(const PlyElement& element, std::vector<std::byte>* scalars) {
    for (std::size_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) {
        const std::size_t items = property.list_count_type ? list_items(element, property, i) : 1;
        const std::size_t size = size_of(property.type);
        if (items > data_.size() / size) {
          fail_short(element, i);
        }
        if (!property.list_count_type && scalars != nullptr) {
          scalars->insert(scalars->end(), data_.begin(), data_.begin() + size);
        }
        data_ = data_.subspan(items * size);
      }
    }
  }

  std::size_t list_items(const PlyElement& element, const PlyProperty& property, std::size_t i) {
    const Column count{"", *property.list_count_type, data_.data(), 0, swapped_};
    const std::size_t size = size_of(count.type);
    if (size > data_.size()) {
      fail_short(element, i);
    }
    std::size_t items = 0;
    for_each_value(count, 1, [&](std::size_t, auto value) {
      if (value < 0) {
        throw ReadError("PLY: list " + in_quotes(property.name) + " has a negative length");
      }
      items = static_cast<std::size_t>(value);
    });
    data_ = data_.subspan(size);
    return items;
  }

  Bytes data_;
  bool swapped_;
};

// Reads ascii elements, one a line.
class AsciiElements {
 public:
  AsciiElements(std::string_view text, std::size_t header_lines)
      : lines_(text), header_lines_(header_lines) {}

  void skip(const PlyElement& element) {
    for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      (void)next_line(element, i);
    }
  }

  void read(const PlyElement& element, PointTable& table) {
    const std::size_t step = element.scalar_step();
    for (std::size_t i = 0; i < element.count && step > 0; ++i) {
      const std::string_view line = next_line(element, i);
      table.storage.resize((i + 1) * step);
      read_line(element, line, table.storage.data() + i * step);
    }
    add_columns(element, table.storage.data(), false, table);
  }

 private:
  std::string_view next_line(const PlyElement& element, std::size_t i) {
    std::string_view line;
    do {
      if (!lines_.next(line)) {
        fail_short(element, i);
      }
    } while (line.find_first_not_of(" \t\r") == std::string_view::npos);
    return line;
  }

  void read_line(const PlyElement& element, std::string_view line, std::byte* out) {
    for (const PlyProperty& property : element.properties) {
      const std::string_view word = take_word(line);
      if (property.list_count_type) {
        std::size_t items = 0;
        if (!parse_count(word, items)) {
          fail(property, word);
        }
        for (std::size_t item = 0; item < items; ++item) {
          if (take_word(line).empty()) {
            fail(property, "");
          }
        }
        continue;
      }
      if (!store_number(word, property.type, out)) {
        fail(property, word);
      }
      out += size_of(property.type);
    }
  }

  [[noreturn]] void fail(const PlyProperty& property, std::string_view word) const {
    throw ReadError("PLY line " + std::to_string(header_lines_ + lines_.line_number()) +
                    ": property " + in_quotes(property.name) + " is " + in_quotes(word) +
                    "; expected " + (property.list_count_type ? "a list of " : "a ") +
                    name_of(property.type));
  }

  LineReader lines_;
  std::size_t header_lines_;
};

template <typename Elements>
void read_vertices(const PlyHeader& header, Elements elements, PointTable& table) {
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      if (element.scalar_step() == 0) {
        throw ReadError("PLY: vertices without a number; expected properties x, y, z");
      }
      elements.read(element, table);
      return;
    }
    elements.skip(element);
  }
  throw ReadError("PLY: no element 'vertex' among " + std::to_string(header.elements.size()));
}

}  // namespace

PointTable parse_ply(std::span<const std::byte> file) {
  const PlyHeader header = parse_ply_header(text_of(file));
  const Bytes data = file.subspan(header.data_offset);
  PointTable table;
  if (header.format == PlyFormat::ascii) {
    table.format = "PLY ascii";
    read_vertices(header, AsciiElements(text_of(data), header.lines), table);
    return table;
  }
  const bool big = header.format == PlyFormat::big_endian;
  table.format = big ? "PLY binary_big_endian" : "PLY binary_little_endian";
  const bool swapped = big == (std::endian::native == std::endian::little);
  read_vertices(header, BinaryElements(data, swapped), table);
  return table;
}

}  // namespace surefoot::io
