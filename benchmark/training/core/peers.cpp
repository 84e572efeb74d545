// SPDX-License-Identifier: MIT
#include "benchmark/training/core/peers.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include <arpa/inet.h>
#include <fmt/core.h>
#include <netdb.h>
#include <sys/socket.h>
#include <torch/csrc/distributed/c10d/PrefixStore.hpp>
#include <torch/csrc/distributed/c10d/ProcessGroupGloo.hpp>
#include <torch/csrc/distributed/c10d/TCPStore.hpp>
#include <unistd.h>

#include "agent/perception/torch.h"
#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds kBeat{200};    // between signs of life
constexpr milliseconds kGrace{4000};  // without one: is not there any more
constexpr milliseconds kLinger{60000};
constexpr milliseconds kPoll{50};
constexpr std::size_t kLongestReason = 300;

std::vector<std::uint8_t> BytesOf(const std::string& text) {
  return {text.begin(), text.end()};
}

/// Waits until `is_so`, or for so long. Returns whether it is.
bool WaitFor(milliseconds time, const std::function<bool()>& is_so) {
  const Clock::time_point end = Clock::now() + time;
  while (!is_so()) {
    if (Clock::now() >= end) return false;
    std::this_thread::sleep_for(kPoll);
  }
  return true;
}

/// The address of this machine that the other one can be reached from; empty if none.
std::string OwnAddress(const std::string& other, int port) {
  addrinfo hints = {};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  if (::getaddrinfo(other.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) return "";
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner(found, &::freeaddrinfo);
  std::string address;
  const int socket = ::socket(found->ai_family, found->ai_socktype | SOCK_CLOEXEC, 0);
  if (socket < 0) return "";
  sockaddr_storage own = {};
  socklen_t length = sizeof(own);
  // Nothing is sent by this: it only chooses the way.
  if (::connect(socket, found->ai_addr, found->ai_addrlen) == 0 &&
      ::getsockname(socket, reinterpret_cast<sockaddr*>(&own), &length) == 0) {
    std::vector<char> text(NI_MAXHOST);
    if (::getnameinfo(reinterpret_cast<sockaddr*>(&own), length, text.data(),
                      static_cast<socklen_t>(text.size()), nullptr, 0, NI_NUMERICHOST) == 0) {
      address = text.data();
    }
  }
  ::close(socket);
  return address;
}

std::shared_ptr<gloo::transport::Device> DeviceOf(const PeerPlace& place) {
  if (const char* interface = std::getenv("GLOO_SOCKET_IFNAME")) {
    return c10d::ProcessGroupGloo::createDeviceForInterface(interface);
  }
  const std::string address = OwnAddress(place.address, place.port);
  if (address.empty()) return c10d::ProcessGroupGloo::createDefaultDevice();
  return c10d::ProcessGroupGloo::createDeviceForHostname(address);
}

/// Gloo writes to its sockets by writev, which kills the process by SIGPIPE where the other end is
/// gone already: it must live on to say who is gone.
void IgnoreBrokenPipes() {
  struct sigaction now = {};
  if (::sigaction(SIGPIPE, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) return;
  now.sa_handler = SIG_IGN;
  ::sigaction(SIGPIPE, &now, nullptr);
}

}  // namespace

/// Tells again and again, in a thread of its own, that this process lives.
class Heart {
 public:
  explicit Heart(std::function<void()> beat)
      : thread_([this, beat = std::move(beat)] {
          std::unique_lock lock(mutex_);
          try {
            do {
              beat();
            } while (!wake_.wait_for(lock, kBeat, [this] {
              return stops_;
            }));
          } catch (const std::exception&) {
            return;  // there is nobody to tell
          }
        }) {}
  ~Heart() {
    {
      const std::lock_guard lock(mutex_);
      stops_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }
  Heart(const Heart&) = delete;
  Heart& operator=(const Heart&) = delete;
  Heart(Heart&&) = delete;
  Heart& operator=(Heart&&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stops_ = false;
  std::thread thread_;
};

/// The store, where all leave notes, and the group, which sends numbers.
class Peers::Link {
 public:
  explicit Link(const PeerPlace& place) : place_(place), timeout_(seconds(place.timeout_s)) {
    IgnoreBrokenPipes();
    Open();
    heart_ = std::make_unique<Heart>([this] {
      notes_->add(Key("beat", place_.rank), 1);
    });
    Meet();
    auto options = c10d::ProcessGroupGloo::Options::create(timeout_);
    options->threads = 1;
    options->devices.push_back(DeviceOf(place));
    group_ = c10::make_intrusive<c10d::ProcessGroupGloo>(notes_, place.rank, place.size, options);
  }

  at::Tensor Gather(const at::Tensor& own) {
    std::vector<std::vector<at::Tensor>> all(1);
    std::vector<at::Tensor> input = {own.detach().contiguous()};
    const at::Tensor stacked = [&] {
      std::vector<std::int64_t> shape = own.sizes().vec();
      shape.insert(shape.begin(), place_.size);
      return torch::empty(shape, own.options());
    }();
    for (std::int64_t rank = 0; rank < place_.size; ++rank) all[0].push_back(stacked[rank]);
    group_->allgather(all, input)->wait();
    return stacked;
  }

  void Broadcast(at::Tensor* tensor) {
    std::vector<at::Tensor> tensors = {*tensor};
    group_->broadcast(tensors)->wait();
  }

  /// Why the group does not work any more, in a line.
  std::string Trouble(const std::string& error) {
    std::string trouble;
    try {
      trouble = Missing();
    } catch (const std::exception&) {
      // Rank 0 keeps the notes.
      trouble = place_.rank == 0 || place_.has_store ? "" : Name(0) + " is gone" + kRemedy;
    }
    if (trouble.empty()) trouble = "the processes have lost each other: " + error.substr(0, 200);
    Close();
    return trouble;
  }

  void Leave(const std::string& why) {
    if (is_closed_) return;
    Note("left", why.substr(0, kLongestReason));
    Close();
  }

 private:
  static constexpr const char* kRemedy =
      "; start them all again: the training goes on from its last checkpoint";

  std::string Name(int rank) const { return fmt::format("process {} of {}", rank, place_.size); }
  static std::string Key(const std::string& note, int rank) {
    return fmt::format("{}/{}", note, rank);
  }
  void Note(const std::string& note, const std::string& text) {
    notes_->set(Key(note, place_.rank), BytesOf(text + " "));
  }
  bool Has(const std::string& note, int rank) { return notes_->check({Key(note, rank)}); }

  void Open() {
    c10d::TCPStoreOptions options;
    options.port = static_cast<std::uint16_t>(place_.port);
    options.isServer = place_.rank == 0 && !place_.has_store;
    options.waitWorkers = false;
    options.timeout = timeout_;
    try {
      store_ = c10::make_intrusive<c10d::TCPStore>(place_.address, options);
    } catch (const std::exception&) {
      const std::string where = fmt::format("{}:{}", place_.address, place_.port);
      if (options.isServer) {
        throw sim::Error("process 0 cannot wait for the others at " + where +
                         "; choose another MASTER_PORT, or set MASTER_ADDR to this machine");
      }
      throw sim::Error(fmt::format(
          "{} does not answer at {} (waited {} s); start it, or set MASTER_ADDR and MASTER_PORT",
          Name(0), where, place_.timeout_s));
    }
    notes_ = c10::make_intrusive<c10d::PrefixStore>("bulletnav" + place_.round, store_);
    notes_->setTimeout(timeout_);
  }

  /// Waits until all are there.
  void Meet() {
    std::vector<int> missing;
    bool has_lost = false;
    try {
      Note("here", "");
      WaitFor(timeout_, [&] {
        missing.clear();
        for (int rank = 0; rank < place_.size; ++rank) {
          if (!Has("here", rank)) missing.push_back(rank);
        }
        return missing.empty();
      });
    } catch (const std::exception&) {
      has_lost = true;
    }
    if (has_lost)
      throw sim::Error(Name(0) + " is gone before all were there; start them all again");
    if (missing.empty()) return;
    // Those who came later find the notes for a moment more.
    if (place_.rank == 0 && !place_.has_store) std::this_thread::sleep_for(kGrace / 2);
    std::string names;
    for (const int rank : missing) names += (names.empty() ? "" : ", ") + std::to_string(rank);
    throw sim::Error(fmt::format(
        "of {} processes, {} did not come within {} s (RANK {}); start them all, with the same "
        "WORLD_SIZE, MASTER_ADDR and MASTER_PORT",
        place_.size, missing.size(), place_.timeout_s, names));
  }

  /// Others that give no sign of life for a while, and have not said that they would not.
  std::vector<int> Silent() {
    std::vector<std::int64_t> before;
    for (int rank = 0; rank < place_.size; ++rank) before.push_back(Beats(rank));
    std::vector<int> silent;
    WaitFor(std::min(kGrace, timeout_), [&] {
      silent.clear();
      for (int rank = 0; rank < place_.size; ++rank) {
        const bool lives = rank == place_.rank || Has("gone", rank) || Has("left", rank) ||
                           Beats(rank) > before[static_cast<std::size_t>(rank)];
        if (!lives) silent.push_back(rank);
      }
      return silent.empty();
    });
    return silent;
  }
  std::int64_t Beats(int rank) { return notes_->add(Key("beat", rank), 0); }

  std::string Missing() {
    const std::vector<int> silent = Silent();
    if (!silent.empty()) {
      std::string names;
      for (const int rank : silent) names += (names.empty() ? "" : ", ") + std::to_string(rank);
      return fmt::format("process {} of {} is gone, or does not answer{}", names, place_.size,
                         kRemedy);
    }
    for (int rank = 0; rank < place_.size; ++rank) {
      if (!Has("left", rank)) continue;
      const std::vector<std::uint8_t> why = notes_->get(Key("left", rank));
      return fmt::format("{} has ended: {}", Name(rank), std::string(why.begin(), why.end() - 1));
    }
    return "";
  }

  /// Breaks off, so that others notice. Rank 0 keeps the notes until they have read them.
  void Close() noexcept {
    if (is_closed_) return;
    is_closed_ = true;
    try {
      group_.reset();
      Note("gone", "");
      if (place_.rank == 0 && !place_.has_store)
        WaitFor(kLinger, [this] {
          return !IsReadByOthers();
        });
    } catch (const std::exception&) {
      heart_.reset();  // nobody to tell
      return;
    }
    heart_.reset();
  }
  /// Whether somebody lives who has not noticed yet.
  bool IsReadByOthers() {
    const std::vector<int> silent = Silent();
    for (int rank = 1; rank < place_.size; ++rank) {
      const bool lives = std::find(silent.begin(), silent.end(), rank) == silent.end();
      if (lives && !Has("gone", rank)) return true;
    }
    return false;
  }

  PeerPlace place_;
  milliseconds timeout_;
  c10::intrusive_ptr<c10d::TCPStore> store_;
  c10::intrusive_ptr<c10d::Store> notes_;
  c10::intrusive_ptr<c10d::ProcessGroupGloo> group_;
  bool is_closed_ = false;
  std::unique_ptr<Heart> heart_;
};

Peers::Peers() = default;

Peers::Peers(const PeerPlace& place) : place_(place) {
  if (place.size > 1) {
    Guarded<int>([&] {
      link_ = std::make_unique<Link>(place);
      return 0;
    });
  }
}

Peers::~Peers() = default;

int Peers::threads() const {
  if (size() == 1 || place_.local_size == 1) return 0;
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return std::max(1, all / place_.local_size);
}

template <class T>
T Peers::Guarded(const std::function<T()>& work) {
  try {
    return work();
  } catch (const sim::Error&) {
    throw;
  } catch (const std::exception& error) {
    std::string text = error.what();
    text = text.substr(0, text.find('\n'));
    throw sim::Error(link_ ? link_->Trouble(text)
                           : "the processes cannot reach each other: " + text);
  }
}

at::Tensor Peers::Gather(const at::Tensor& own) {
  if (!link_) return own.unsqueeze(0);
  return Guarded<at::Tensor>([&] {
    return link_->Gather(own);
  });
}

std::vector<double> Peers::Gather(std::span<const double> own) {
  if (!link_) return {own.begin(), own.end()};
  const auto size = static_cast<std::int64_t>(own.size());
  const torch::Tensor numbers = torch::empty({size}, torch::kFloat64);
  std::copy(own.begin(), own.end(), numbers.data_ptr<double>());
  const torch::Tensor all = Gather(numbers);
  return {all.data_ptr<double>(), all.data_ptr<double>() + all.numel()};
}

std::string Peers::FromFirst(const std::string& text) {
  if (!link_) return text;
  return Guarded<std::string>([&] {
    torch::Tensor size = torch::full({1}, static_cast<std::int64_t>(text.size()), torch::kInt64);
    link_->Broadcast(&size);
    torch::Tensor bytes =
        torch::zeros({std::max<std::int64_t>(1, size.item<std::int64_t>())}, torch::kUInt8);
    if (is_first()) std::copy(text.begin(), text.end(), bytes.data_ptr<std::uint8_t>());
    link_->Broadcast(&bytes);
    const std::uint8_t* data = bytes.data_ptr<std::uint8_t>();
    return std::string(data, data + size.item<std::int64_t>());
  });
}

void Peers::RequireSame(const std::string& text, const std::string& what) {
  const std::string first = FromFirst(text);
  const double is_same = first == text ? 1.0 : 0.0;
  const std::vector<double> all = Gather(std::span(&is_same, 1));
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    if (all[rank] == 1.0) continue;
    throw sim::Error(
        fmt::format("process {} of {} has another {} than process 0", rank, size(), what));
  }
}

void Peers::Leave(const std::string& why) noexcept {
  if (!link_) return;
  try {
    link_->Leave(why);
  } catch (const std::exception&) {
    return;  // nobody to tell
  }
}

}  // namespace bulletnav::bench
