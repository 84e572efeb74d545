// SPDX-License-Identifier: MIT
#include "python/agent/guarded_call.h"

#include "python/agent/interpreter.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <thread>

#include <pybind11/pybind11.h>
#include <unistd.h>

namespace bulletnav::python {
namespace {

namespace py = pybind11;

std::int64_t NowNs() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// No Exception, so that code which catches those does not catch it. The lock must be held.
PyObject* TimeLimit() {
  static PyObject* const type =
      PyErr_NewException("bulletnav_agent.TimeLimit", PyExc_BaseException, nullptr);
  return type;
}

}  // namespace

struct GuardedCall::State {
  static constexpr std::int64_t kIdle = 0;
  std::atomic<std::int64_t> began_ns = kIdle;  // of the call at work
  std::atomic<std::uint64_t> number = 0;       // of calls
  std::atomic<bool> is_interrupting = false;   // a thread is about it
  // With Python's lock:
  unsigned long thread = 0;
  bool is_interrupted = false;

  void Begin() {
    thread = PyThread_get_thread_ident();
    is_interrupted = false;
    ++number;
    began_ns = NowNs();
  }
  /// If it is still at work.
  void InterruptCall(std::uint64_t call) {
    if (number != call || began_ns == kIdle) return;
    is_interrupted = true;
    PyThreadState_SetAsyncExc(thread, TimeLimit());
  }
  void End() {
    began_ns = kIdle;
    PyThreadState_SetAsyncExc(thread, nullptr);  // what has come too late is not the next call's
  }
};

GuardedCall::GuardedCall() : state_(std::make_shared<State>()) {}

void GuardedCall::Run(const std::function<void()>& work) {
  const pid_t process = ::getpid();
  std::string raised;
  {
    const py::gil_scoped_acquire lock;
    state_->Begin();
    try {
      work();
      state_->End();
    } catch (const py::error_already_set& e) {
      state_->End();
      raised = (state_->is_interrupted ? "gave no answer in time\n" : "") + Traceback(e);
    } catch (...) {
      state_->End();
      EndChild(process);
      throw;
    }
  }
  EndChild(process);
  if (!raised.empty()) throw std::runtime_error(raised);
}

std::optional<double> GuardedCall::busy_s() const {
  const std::int64_t began = state_->began_ns;
  if (began == State::kIdle) return std::nullopt;
  return 1e-9 * static_cast<double>(NowNs() - began);
}

/// In a thread of its own: the lock may never be to be had.
void GuardedCall::Interrupt() {
  if (state_->is_interrupting.exchange(true)) return;
  std::thread([state = state_, number = state_->number.load()] {
    {
      const py::gil_scoped_acquire lock;
      state->InterruptCall(number);
    }
    state->is_interrupting = false;
  }).detach();
}

void EndChild(pid_t own) {
  if (::getpid() != own) ::_exit(1);
}

}  // namespace bulletnav::python
