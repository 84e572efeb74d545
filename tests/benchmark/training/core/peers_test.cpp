// SPDX-License-Identifier: MIT
// Trainings that several processes of this machine share.
#include "benchmark/training/core/peers.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "agent/models/safetensors.h"
#include "benchmark/training/core/registry.h"
#include "sim/base/error.h"
#include "tests/benchmark/training/supervised/watchers.h"
#include "tests/support/houses.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::Watcher;

int FreePort() {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof(address);
  ::bind(socket, reinterpret_cast<sockaddr*>(&address), length);
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &length);
  ::close(socket);
  return ntohs(address.sin_port);
}

/// What a process came to: "" where all went well, else its last words.
using Endings = std::vector<std::string>;

/// What each of `places` does, in a process of its own.
class Processes {
 public:
  using Work = std::function<void(const PeerPlace& place)>;

  static std::vector<PeerPlace> Places(int size, int timeout_s = 60) {
    const int port = FreePort();
    std::vector<PeerPlace> places;
    for (int rank = 0; rank < size; ++rank) {
      PeerPlace& place = places.emplace_back();
      place.rank = rank;
      place.size = size;
      place.local_size = size;
      place.address = "127.0.0.1";
      place.port = port;
      place.timeout_s = timeout_s;
    }
    return places;
  }

  static Endings Run(const std::vector<PeerPlace>& places, const Work& work) {
    const tests::TemporaryFolder folder;
    std::vector<pid_t> children;
    const auto words = [&](const PeerPlace& place) {
      return folder.path() / std::to_string(place.rank);
    };
    for (const PeerPlace& place : places) {
      const pid_t child = ::fork();
      if (child == 0) Child(place, work, words(place));
      children.push_back(child);
    }
    Endings endings;
    for (std::size_t i = 0; i < children.size(); ++i) {
      int status = 0;
      ::waitpid(children[i], &status, 0);
      std::ifstream in(words(places[i]));
      const std::string said((std::istreambuf_iterator<char>(in)), {});
      endings.push_back(WIFSIGNALED(status) ? "killed" : said);
    }
    return endings;
  }

 private:
  [[noreturn]] static void Child(const PeerPlace& place, const Work& work,
                                 const std::filesystem::path& words) {
    std::string said;
    try {
      work(place);
    } catch (const std::exception& error) {
      said = error.what();
    }
    std::ofstream(words) << said;
    ::_exit(0);
  }
};

/// Trains as `train` does: tells the others why it ends.
void TrainAsPeer(const PeerPlace& place, const std::string& config, TrainObserver* observer) {
  const auto peers = std::make_shared<Peers>(place);
  try {
    TrainContext context;
    context.peers = peers;
    const TrainJob job = MakeTraining(sim::ParseYaml(config, "shared.yaml"), "nts", context);
    RunTraining(job, observer, peers.get());
  } catch (const std::exception& error) {
    peers->Leave(error.what());
    throw;
  }
}

class SharedTraining : public testing::Test {
 protected:
  std::string Rooms(const std::string& out, const std::string& more = "") const {
    return "task: four_rooms\nout: " + (folder_.path() / out).string() +
           "\nppo: {lanes: 16, group: 2, rollout: 16, epochs: 2, minibatches: 2}\n"
           "model: {width: 16}\nsteps: 8\nvalidate_every: 3\nvalidation_steps: 20\n" +
           more;
  }
  static Endings Train(int size, const std::string& config) {
    return Processes::Run(Processes::Places(size), [&](const PeerPlace& place) {
      Watcher watcher;
      TrainAsPeer(place, config, &watcher);
    });
  }
  auto Weights(const std::string& out) const {
    return agent::ReadTensorFile(folder_.path() / out / "weights.safetensors").tensors;
  }
  static testing::Matcher<Endings> Well() { return testing::Each(std::string()); }

  const tests::TemporaryFolder folder_;
};

TEST_F(SharedTraining, ComesToTheSameBitsForAnyNumberOfProcesses) {
  for (const int size : {1, 2, 4}) EXPECT_THAT(Train(size, Rooms(std::to_string(size))), Well());
  EXPECT_EQ(Weights("1"), Weights("2"));
  EXPECT_EQ(Weights("1"), Weights("4"));
}

TEST_F(SharedTraining, GoesOnFromItsCheckpointAfterAProcessWasKilled) {
  EXPECT_THAT(Train(1, Rooms("whole")), Well());
  const Endings ends = Processes::Run(Processes::Places(4), [&](const PeerPlace& place) {
    class Killer final : public Watcher {
     public:
      explicit Killer(int rank) : rank_(rank) {}
      void Stepped(int step, double /*loss*/) override {
        if (step == 5 && rank_ == 2) ::raise(SIGKILL);
      }

     private:
      int rank_;
    } killer(place.rank);
    TrainAsPeer(place, Rooms("parts"), &killer);
  });
  for (const std::size_t rank : {0U, 1U, 3U}) {
    EXPECT_THAT(ends[rank], AllOf(HasSubstr("process 2 of 4 is gone"), HasSubstr("start them"),
                                  Not(HasSubstr("\n"))));
  }
  EXPECT_EQ(ends[2], "killed");
  EXPECT_THAT(Train(2, Rooms("parts")), Well());
  EXPECT_EQ(Weights("whole"), Weights("parts"));
}

TEST_F(SharedTraining, TheFirstProcessMayDieToo) {
  const Endings ends = Processes::Run(Processes::Places(2), [&](const PeerPlace& place) {
    class Killer final : public Watcher {
     public:
      explicit Killer(int rank) : rank_(rank) {}
      void Stepped(int step, double /*loss*/) override {
        if (step == 2 && rank_ == 0) ::raise(SIGKILL);
      }

     private:
      int rank_;
    } killer(place.rank);
    TrainAsPeer(place, Rooms("first"), &killer);
  });
  EXPECT_THAT(ends[1], HasSubstr("process 0 of 2 is gone"));
}

TEST_F(SharedTraining, LivesOnAfterAWriteToOneThatIsGone) {
  const Endings ends = Processes::Run(Processes::Places(2), [](const PeerPlace& place) {
    const Peers peers(place);
    std::array<int, 2> pipe = {};
    if (::pipe(pipe.data()) != 0) throw sim::Error("no pipe");
    ::close(pipe[0]);
    const bool is_written = ::write(pipe[1], "x", 1) == 1;
    const int error = errno;
    ::close(pipe[1]);
    if (is_written || error != EPIPE) throw sim::Error("the pipe is not broken");
  });
  EXPECT_THAT(ends, Well());
}

TEST_F(SharedTraining, SaysWhyAProcessHasEnded) {
  const Endings ends = Processes::Run(Processes::Places(2), [&](const PeerPlace& place) {
    class Thrower final : public Watcher {
     public:
      explicit Thrower(int rank) : rank_(rank) {}
      void Stepped(int step, double /*loss*/) override {
        if (step == 2 && rank_ == 1) throw sim::Error("the disk is full");
      }

     private:
      int rank_;
    } thrower(place.rank);
    TrainAsPeer(place, Rooms("full"), &thrower);
  });
  EXPECT_THAT(ends[0], HasSubstr("process 1 of 2 has ended: the disk is full"));
  EXPECT_EQ(ends[1], "the disk is full");
}

TEST_F(SharedTraining, TellsWhoDoesNotCome) {
  const auto meet = [](const PeerPlace& place) {
    Peers peers(place);
  };
  // Long enough for two processes to find each other on a machine full of other work.
  std::vector<PeerPlace> places = Processes::Places(3, 10);
  const Endings without_last = Processes::Run({places[0], places[1]}, meet);
  for (const std::string& end : without_last) {
    EXPECT_THAT(end, AllOf(HasSubstr("1 did not come"), HasSubstr("RANK 2")));
  }
  EXPECT_THAT(Processes::Run({Processes::Places(2, 1)[1]}, meet)[0],
              HasSubstr("process 0 of 2 does not answer"));
}

TEST_F(SharedTraining, RefusesWhatCannotBeShared) {
  for (const std::string& end : Train(3, Rooms("three"))) {
    EXPECT_THAT(end, HasSubstr("processes must be 2, 4, 8"));
  }
  const Endings ends = Processes::Run(Processes::Places(2), [&](const PeerPlace& place) {
    Watcher watcher;
    TrainAsPeer(place, Rooms("other", "seed: " + std::to_string(place.rank) + "\n"), &watcher);
  });
  EXPECT_THAT(ends[0], HasSubstr("process 1 of 2 has another config"));
}

TEST_F(SharedTraining, OfPoliciesTooIsTheSame) {
  tests::WriteShellHouses(folder_.path() / "houses", 2, 1);
  const std::string index = (folder_.path() / "houses/index.json").string();
  const auto config = [&](const std::string& task, const std::string& out,
                          const std::string& more) {
    return "task: " + task + "\nout: " + (folder_.path() / (task + out)).string() +
           "\ndata: {houses: {index: " + index +
           ", split: train}}\nvalidation: {houses: {index: " + index +
           ", split: test}}\nvalidation_episodes: 3\n"
           "model: {width: 16, rows: 32, features: 32, memory: 32, step_limit: 30, precision: "
           "float32}\nsteps: 3\nvalidate_every: 2\n" +
           more;
  };
  for (const auto& [task, more] :
       {std::pair{"ppo", "ppo: {lanes: 4, group: 1, rollout: 4}\n"},
        std::pair{"imitation",
                  "lanes: 4\ngroup: 1\nrollout: 4\nepochs: 2\nminibatches: 2\n"
                  "dagger: {from: 0, to: 2, least: 0.2}\n"}}) {
    for (const int size : {1, 2}) {
      EXPECT_THAT(Train(size, config(task, std::to_string(size), more)), Well());
    }
    EXPECT_EQ(Weights(std::string(task) + "1"), Weights(std::string(task) + "2"));
    std::ifstream one(folder_.path() / (std::string(task) + "1/curves.csv"));
    std::ifstream two(folder_.path() / (std::string(task) + "2/curves.csv"));
    EXPECT_EQ(std::string((std::istreambuf_iterator<char>(one)), {}),
              std::string((std::istreambuf_iterator<char>(two)), {}));
  }
}

/// Two machines, as far as a kernel can play them: network namespaces with a cable between them.
class Machines {
 public:
  Machines() {
    const bool has_root = ::geteuid() == 0;
    is_there_ = has_root && Do("ip netns add bulletnav_a") && Do("ip netns add bulletnav_b") &&
                Do("ip link add bnav_a netns bulletnav_a type veth peer name bnav_b netns "
                   "bulletnav_b") &&
                Set("a", 1) && Set("b", 2);
  }
  ~Machines() {
    if (::geteuid() != 0) return;
    Do("ip netns del bulletnav_a");
    Do("ip netns del bulletnav_b");
  }
  Machines(const Machines&) = delete;
  Machines& operator=(const Machines&) = delete;
  Machines(Machines&&) = delete;
  Machines& operator=(Machines&&) = delete;

  bool is_there() const { return is_there_; }
  /// The calling process goes on in there.
  static void Enter(int rank) {
    const std::string file = std::string("/run/netns/bulletnav_") + (rank == 0 ? "a" : "b");
    const int place = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (place < 0 || ::setns(place, CLONE_NEWNET) != 0) throw sim::Error("cannot enter " + file);
    ::close(place);
  }

 private:
  static bool Do(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
  }
  static bool Set(const std::string& name, int number) {
    const std::string in = "ip -n bulletnav_" + name + " ";
    return Do(in + "addr add 10.77.0." + std::to_string(number) + "/24 dev bnav_" + name) &&
           Do(in + "link set bnav_" + name + " up") && Do(in + "link set lo up");
  }

  bool is_there_ = false;
};

TEST_F(SharedTraining, WorksFromMachineToMachine) {
  const Machines machines;
  if (!machines.is_there()) {
    GTEST_SKIP() << "needs root, the program ip (iproute2) and a kernel with network namespaces";
  }
  EXPECT_THAT(Train(1, Rooms("whole")), Well());
  std::vector<PeerPlace> places = Processes::Places(2);
  for (PeerPlace& place : places) place.address = "10.77.0.1";
  const Endings ends = Processes::Run(places, [&](const PeerPlace& place) {
    Machines::Enter(place.rank);
    Watcher watcher;
    // Folders of their own, as machines have: what the first one writes counts.
    TrainAsPeer(place, Rooms("machine" + std::to_string(place.rank)), &watcher);
  });
  EXPECT_THAT(ends, Well());
  EXPECT_EQ(Weights("whole"), Weights("machine0"));
}

}  // namespace
}  // namespace bulletnav::bench
