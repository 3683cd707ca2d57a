// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/terminal/interrupt.hpp"

namespace kanec {
namespace {

// A signal handler is given no context: this is the one thing that it can reach.
volatile sig_atomic_t received = 0;

extern "C" void kanec_note_signal(int) { received = 1; }

void note(int signal, struct sigaction& before) {
  struct sigaction action {};
  action.sa_handler = kanec_note_signal;
  ::sigaction(signal, nullptr, &before);
  if (before.sa_handler != SIG_IGN) ::sigaction(signal, &action, nullptr);
}

}  // namespace

Interrupts::Interrupts() {
  note(SIGINT, interrupt_before_);
  note(SIGTERM, terminate_before_);
}

Interrupts::~Interrupts() {
  ::sigaction(SIGINT, &interrupt_before_, nullptr);
  ::sigaction(SIGTERM, &terminate_before_, nullptr);
}

void Interrupts::poll() const {
  if (received != 0) throw Interrupted();
}

}  // namespace kanec
