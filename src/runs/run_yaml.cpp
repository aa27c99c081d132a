// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_yaml.hpp"

#include <yaml-cpp/yaml.h>

#include <string_view>

#include "io/file_writer.hpp"
#include "io/recording.hpp"
#include "runs/config_file.hpp"
#include "text/utf8.hpp"

namespace surefoot::runs {

namespace {

/// Text as it is; what is none as YAML's !!binary, in base64.
void emit(YAML::Emitter& out, const std::string& value) {
  if (text::is_utf8(value)) {
    out << value;
  } else {
    out << YAML::Binary(reinterpret_cast<const unsigned char*>(value.data()), value.size());
  }
}

/// What emit() wrote, of a scalar. Throws YAML::Exception for what is no base64.
std::string text_of(const YAML::Node& scalar) {
  if (scalar.Tag() != "tag:yaml.org,2002:binary") return scalar.Scalar();
  const auto binary = scalar.as<YAML::Binary>();
  return {reinterpret_cast<const char*>(binary.data()), binary.size()};
}

/// Tells `visit` every entry with its section, in the order in which they are written.
template <typename Record, typename Visit>
void each_entry(Record& run, Visit&& visit) {
  visit("", "surefoot", run.version);
  visit("", "command", run.command);
  visit("", "method", run.method);
  visit("input", "path", run.input);
  visit("input", "content", run.content);
  visit("input", "notes", run.notes);
  visit("", "options", run.options);
  visit("result", "scans", run.scans);
  visit("result", "unreadable_scans", run.unreadable);
  visit("result", "untrusted_scans", run.untrusted);
  visit("result", "segments", run.segments);
  visit("result", "interrupted", run.interrupted);
  visit("result", "level", run.level);
  visit("result", "pose_of", run.pose_of);
  visit("machine", "processor", run.processor);
  visit("machine", "cores", run.cores);
  visit("machine", "threads", run.threads);
  visit("machine", "compiler", run.compiler);
}

class Writer {
 public:
  Writer() { out_ << YAML::BeginMap; }

  template <typename Value>
  void operator()(const std::string& section, const char* key, const Value& value) {
    begin(section);
    out_ << YAML::Key << key << YAML::Value;
    write(value);
  }
  [[nodiscard]] std::string finish(const OptionTexts& parameters) {
    begin("");
    out_ << YAML::Key << "parameters" << YAML::Value;
    emit_parameters(out_, parameters);
    out_ << YAML::EndMap;
    return std::string(out_.c_str()) + '\n';
  }

 private:
  void begin(const std::string& section) {
    if (section == section_) return;
    if (!section_.empty()) out_ << YAML::EndMap;
    if (!section.empty()) out_ << YAML::Key << section << YAML::Value << YAML::BeginMap;
    section_ = section;
  }
  void write(const std::string& value) { emit(out_, value); }
  void write(const std::vector<std::string>& values) {
    out_ << YAML::BeginSeq;
    for (const std::string& value : values) emit(out_, value);
    out_ << YAML::EndSeq;
  }
  void write(const OptionTexts& options) {
    out_ << YAML::BeginMap;
    for (const auto& [name, value] : options) {
      out_ << YAML::Key << name << YAML::Value;
      emit(out_, value);
    }
    out_ << YAML::EndMap;
  }

  YAML::Emitter out_;
  std::string section_;
};

class Reader {
 public:
  explicit Reader(const YAML::Node& root) : root_(root) {}

  template <typename Value>
  void operator()(const char* section, const char* key, Value& value) const {
    const YAML::Node group = *section == '\0' ? root_ : root_[section];
    if (group && group.IsMap() && group[key]) read(group[key], value);
  }

 private:
  static void read(const YAML::Node& node, std::string& value) {
    if (node.IsScalar()) value = text_of(node);
  }
  static void read(const YAML::Node& node, std::vector<std::string>& values) {
    if (!node.IsSequence()) return;
    for (const YAML::Node& item : node) {
      if (item.IsScalar()) values.push_back(text_of(item));
    }
  }
  static void read(const YAML::Node& node, OptionTexts& options) {
    if (!node.IsMap()) return;
    for (const auto& item : node) {
      if (item.first.IsScalar() && item.second.IsScalar()) {
        options.emplace_back(item.first.Scalar(), text_of(item.second));
      }
    }
  }

  const YAML::Node& root_;
};

OptionTexts read_parameters(const YAML::Node& groups) {
  OptionTexts result;
  if (!groups || !groups.IsMap()) return result;
  for (const auto& group : groups) {
    if (!group.first.IsScalar() || !group.second.IsMap()) continue;
    for (const auto& item : group.second) {
      if (!item.first.IsScalar() || !item.second.IsScalar()) continue;
      result.emplace_back(group.first.Scalar() + '.' + item.first.Scalar(), item.second.Scalar());
    }
  }
  return result;
}

}  // namespace

OptionTexts parameter_texts(const Config& config) {
  OptionTexts result;
  for (const ParameterInfo& info : parameters()) {
    if (!reads_parameter(config, info.name)) continue;
    result.emplace_back(info.name, get_parameter(config, info.name));
  }
  return result;
}

std::string run_yaml_text(const RunDescription& run) {
  Writer writer;
  each_entry(run, writer);
  return writer.finish(run.parameters);
}

void write_run_yaml(const std::filesystem::path& file, const RunDescription& run) {
  io::write_whole_file(file, run_yaml_text(run));
}

RunDescription read_run_yaml(const std::filesystem::path& file) {
  try {
    const YAML::Node root = YAML::LoadFile(file.string());
    if (root.IsNull()) return {};
    if (!root.IsMap()) throw io::ReadError(file.string() + ": expected a run's run.yaml");
    RunDescription run;
    each_entry(run, Reader(root));
    run.parameters = read_parameters(root["parameters"]);
    return run;
  } catch (const YAML::Exception& error) {
    throw io::ReadError(file.string() + ": not YAML: " + error.what());
  }
}

}  // namespace surefoot::runs
