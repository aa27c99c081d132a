// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "process/interrupt.hpp"

#include <csignal>

namespace surefoot::process {

namespace {

volatile std::sig_atomic_t signalled = 0;

void on_signal(int signal) {
  signalled = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  signalled = 0;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  // Of a terminal that goes; who asked not to hear of it (nohup) does not.
  ignores_hangup_ = std::signal(SIGHUP, on_signal) == SIG_IGN;
  if (ignores_hangup_) std::signal(SIGHUP, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  if (!ignores_hangup_) std::signal(SIGHUP, SIG_DFL);
}

bool InterruptGuard::interrupted() const { return signalled != 0; }

}  // namespace surefoot::process
