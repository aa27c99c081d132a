// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string_view>
#include <system_error>
#include <thread>

namespace surefoot::test {

namespace fs = std::filesystem;

namespace {

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr rlim_t kMemory = 2'147'483'648;
#else
constexpr rlim_t kMemory = RLIM_INFINITY;  // sanitizers reserve terabytes of addresses
#endif

constexpr const char* kErrors = "stderr.txt";

void redirect(int stream, const fs::path& file, int flags) {
  const int opened = open(file.c_str(), flags | O_CLOEXEC, 0644);
  if (opened < 0 || dup2(opened, stream) < 0) _exit(127);
}

[[noreturn]] void become_surefoot(std::vector<char*> arguments, const fs::path& folder,
                                  const Surroundings& surroundings) {
  if (chdir(folder.c_str()) != 0) _exit(127);
  redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
  redirect(STDOUT_FILENO, surroundings.output, O_WRONLY | O_CREAT | O_TRUNC);
  redirect(STDERR_FILENO, kErrors, O_WRONLY | O_CREAT | O_TRUNC);
  const rlimit memory{kMemory, kMemory};
  setrlimit(RLIMIT_AS, &memory);
  if (surroundings.most_file_bytes != UINT64_MAX) {
    const rlimit bytes{surroundings.most_file_bytes, surroundings.most_file_bytes};
    setrlimit(RLIMIT_FSIZE, &bytes);
    std::signal(SIGXFSZ, SIG_IGN);  // writing fails, as it does where there is no room
  }
  alarm(surroundings.most_seconds);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const ProcessResult& result) {
  return out << "exit code " << result.exit_code << ", signal " << result.signal << "\nstdout:\n"
             << result.output << "stderr:\n"
             << result.errors;
}

Process::Process(const std::vector<std::string>& arguments, const fs::path& folder,
                 const Surroundings& surroundings)
    : folder_(folder), output_(surroundings.output) {
  std::vector<std::string> words{surroundings.program.empty() ? SUREFOOT_PROGRAM
                                                              : surroundings.program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  id_ = fork();
  if (id_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (id_ == 0) become_surefoot(pointers, folder, surroundings);
}

void Process::send(int signal) const { kill(id_, signal); }

void Process::wait_until_catching(int signal) const {
  const std::string status = "/proc/" + std::to_string(id_) + "/status";
  constexpr std::string_view kCaught = "SigCgt:", kState = "State:\tZ";
  while (true) {
    std::ifstream in(status);
    std::string line;
    std::uint64_t caught = 0;
    bool has_ended = !in;
    while (std::getline(in, line)) {
      has_ended |= line.starts_with(kState);
      if (line.starts_with(kCaught)) caught = std::stoull(line.substr(kCaught.size()), nullptr, 16);
    }
    if (has_ended || ((caught >> (signal - 1)) & 1U) != 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

ProcessResult Process::wait() const {
  int status = 0;
  while (waitpid(id_, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  }
  ProcessResult result;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  if (output_ != "/dev/full") result.output = file_content(folder_ / output_);
  result.errors = file_content(folder_ / kErrors);
  return result;
}

ProcessResult run_surefoot(const std::vector<std::string>& arguments, const fs::path& folder,
                           const Surroundings& surroundings) {
  return Process(arguments, folder, surroundings).wait();
}

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "surefoot_cli_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), name);
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string file_content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::size_t lines_of(const fs::path& file) {
  const std::string content = file_content(file);
  return static_cast<std::size_t>(std::count(content.begin(), content.end(), '\n'));
}

void write_content(const fs::path& file, const std::string& content) {
  std::ofstream out(file, std::ios::binary);
  out << content;
  out.close();
  if (!out) throw std::system_error(errno, std::generic_category(), file.string());
}

}  // namespace surefoot::test
