// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What others ask of a live run, done on the run's own thread between two scans.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace surefoot::live {

struct CommandAnswer {
  bool done = false;
  std::string text;  ///< what was done, or why not
};

class CommandQueue {
 public:
  /// On any thread but the run's: waits until it was done, ten seconds at most.
  [[nodiscard]] CommandAnswer ask(const std::string& command);
  /// On the run's thread: does what was asked since. What `execute` throws is the answer.
  void work(const std::function<CommandAnswer(const std::string& command)>& execute);
  /// Nothing is done any more: who waits, and who will ask, is told so.
  void close();

 private:
  struct Asked {
    std::string command;
    CommandAnswer answer;
    bool answered = false;
  };
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::shared_ptr<Asked>> waiting_;
  bool closed_ = false;
};

}  // namespace surefoot::live
