#include "tests/bench/crash/cluster_ordeal.hpp"

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/statvfs.h>
#include <system_error>
#include <unistd.h>

#include "blackboard/cluster/etcd_client.hpp"
#include "blackboard/cluster/followed_log.hpp"

namespace pizarra::bench {

namespace {

using namespace std::chrono_literals;

// Etcd sets aside 128 MB for what it writes first.
constexpr const char* disk_size = "size=192m";
// Of a member that is slow: it runs 10 ms of every 100.
constexpr auto stutter_stops = 90ms;
constexpr auto stutter_runs = 10ms;
constexpr auto reading_patience = 60s;

void must(bool done, const char* what) {
  if (!done) throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

SmallDisk::SmallDisk(std::string folder) : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_);
  must(unshare(CLONE_NEWNS) == 0, "unshare");
  must(mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0, "mount /");
  must(mount("tmpfs", folder_.c_str(), "tmpfs", 0, disk_size) == 0, "mount a small disk");
}

SmallDisk::~SmallDisk() { umount2(folder_.c_str(), MNT_DETACH); }

void SmallDisk::fill() const {
  struct statvfs space {};
  const int file = open((folder_ + "/ballast").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const bool known = file >= 0 && fstatvfs(file, &space) == 0;
  const auto bytes = static_cast<off_t>(space.f_bavail * space.f_frsize);
  const bool filled = known && (bytes == 0 || fallocate(file, 0, 0, bytes) == 0 || errno == ENOSPC);
  close(file);
  must(filled, "fill a small disk");
}

void SmallDisk::empty() const { std::filesystem::remove(folder_ + "/ballast"); }

ClusterOrdeal::ClusterOrdeal(const std::string& folder, std::uint64_t seed, std::function<bool()> is_stopped)
    : Ordeal(seed, std::move(is_stopped)),
      disk_(folder + "/small-disk"),
      cell_(network::Network::Wires::forwarded, disk_.folder()) {
  cell_.enter_the_host_beside();
  for (std::size_t board = 0; board < ClusterCell::most_boards; ++board) {
    cell_.network().put_clock_off(ClusterCell::host(board), 0s);
    cell_.kill_board(board);
    cell_.start_board(board);
  }
  for (int number = 0; number < clients; ++number) start_client(number);
  wait_until_begun();
}

std::string ClusterOrdeal::come_to_the_board(int client) {
  cell_.enter(static_cast<std::size_t>(client) % ClusterCell::members);
  return cell_.boards();
}

void ClusterOrdeal::round() {
  if (to_come_.empty()) {
    for (std::size_t kind = 0; kind < kinds; ++kind) to_come_.push_back(kind);
  }
  std::swap(to_come_[below(to_come_.size())], to_come_.back());
  const std::size_t kind = to_come_.back();
  to_come_.pop_back();
  ++came_[kind];
  harm(static_cast<Fault>(kind));
  pass(between(300, 1500));
  start_who_ended();
}

void ClusterOrdeal::harm(Fault fault) {
  const int number = some_client();
  const std::size_t host = some_host();
  const std::size_t member = below(2) == 0 ? some_member() : std::min(cell_.leading_member(), ClusterCell::members - 1);
  const std::size_t leader = std::min(cell_.leading_board(), ClusterCell::most_boards - 1);
  switch (fault) {
    case Fault::kill_leader:
      return kill_board(leader);
    case Fault::kill_board:
      return kill_board(some_board());
    case Fault::kill_client:
      return start_client(number);
    case Fault::kill_member:
      return kill_member(member);
    case Fault::cut_power:
      return cut_power(host);
    case Fault::stop_leader:
      return stop_for([this, leader] { return cell_.board(leader); }, between(50, 2000));
    case Fault::stop_member:
      return stop_for([this, member] { return cell_.member(member); }, between(50, 2000));
    case Fault::stop_client:
      return stop_for([this, number] { return client(number); }, between(50, 2500));
    case Fault::slow_member:
      return stutter(member, 1 + static_cast<int>(below(30)));
    case Fault::isolate:
      return link(host, "both cut");
    case Fault::deafen:
      return link(host, "in cut");
    case Fault::silence:
      return link(host, "out cut");
    case Fault::jump_clock:
      return jump_clock(some_board());
    default:
      disk_.fill();
      return later(between(500, 4000), [this] { disk_.empty(); });
  }
}

void ClusterOrdeal::kill_board(std::size_t number) {
  cell_.kill_board(number);
  later(between(0, 1500), [this] { cell_.start_what_was_killed(); });
}

void ClusterOrdeal::kill_member(std::size_t number) {
  cell_.kill_member(number);
  later(between(0, 2000), [this] { cell_.start_what_was_killed(); });
}

void ClusterOrdeal::cut_power(std::size_t number) {
  cell_.kill_host(number);
  later(between(100, 2500), [this, number] {
    cell_.start_what_was_killed();
    for (int each = 0; each < clients; ++each) {
      if (static_cast<std::size_t>(each) % ClusterCell::members == number) start_client(each);
    }
  });
}

void ClusterOrdeal::link(std::size_t number, const std::string& conditions) {
  cell_.network().link(ClusterCell::host(number), conditions);
  later(between(100, 3000), [this, number] { cell_.network().link(ClusterCell::host(number), "both"); });
}

void ClusterOrdeal::jump_clock(std::size_t number) {
  const auto seconds = std::chrono::seconds(static_cast<std::int64_t>(below(7200)) - 3600);
  cell_.network().put_clock_off(ClusterCell::host(number), seconds);
}

void ClusterOrdeal::stutter(std::size_t member, int times) {
  stop_for([this, member] { return cell_.member(member); }, stutter_stops);
  if (times > 1) later(stutter_stops + stutter_runs, [this, member, times] { stutter(member, times - 1); });
}

// Etcd ends by itself where its disk is full. A board must not.
void ClusterOrdeal::start_who_ended() {
  for (std::size_t number = 0; number < ClusterCell::members; ++number) {
    const Child* const member = cell_.member(number);
    if (member != nullptr && member->ended()) kill_member(number);
  }
  for (std::size_t number = 0; number < ClusterCell::most_boards; ++number) {
    const Child* const board = cell_.board(number);
    if (board != nullptr && board->ended())
      throw std::runtime_error("a board ended by itself: " + cell_.last_complaint(number));
  }
}

std::size_t ClusterOrdeal::some_host() {
  const std::uint64_t choice = below(3);
  const std::size_t leader = choice == 0 ? cell_.leading_board() : cell_.leading_member();
  return choice == 2 || leader >= ClusterCell::members ? some_member() : leader;
}

void ClusterOrdeal::mend() {
  disk_.empty();
  start_who_ended();
  pass(3s);
  cell_.start_what_was_killed();
  for (int number = 0; number < clients; ++number) {
    if (client(number)->ended()) start_client(number);
  }
}

// Every entry that the head counts is there.
Result<void> ClusterOrdeal::read_the_end(store::Store& store) {
  for (std::size_t number = 0; number < ClusterCell::most_boards; ++number) cell_.kill_board(number);
  const Result<cluster::LogAddress> address = cluster::LogAddress::from(cell_.log(), "", true);
  if (!address) return fail(address);
  const Result<std::unique_ptr<cluster::EtcdClient>> client = cluster::EtcdClient::open(*address);
  if (!client) return fail(client);
  const cluster::LogKeys keys(address->cell);
  // Etcd on a busy machine lets one wait, and may be choosing a leader.
  const Clock::time_point patience = Clock::now() + reading_patience;
  Result<std::optional<std::string>> head = cluster::get(**client, keys.head(), 5s);
  while (!head && Clock::now() < patience) head = cluster::get(**client, keys.head(), 5s);
  if (!head) return fail(head);
  cluster::FollowedLog followed(**client, keys, store, {});
  const std::uint64_t newest = std::stoull(head->value_or("0"));
  Result<void> read = followed.follow_to(newest);
  while (!read && read.error().symbol == "unavailable" && Clock::now() < patience) read = followed.follow_to(newest);
  return read;
}

std::string ClusterOrdeal::faults() const {
  static constexpr const char* names[kinds] = {
      "leading board killed", "board killed",   "client killed", "member killed", "power cut", "leading board stopped",
      "member stopped",       "client stopped", "member slow",   "host cut off",  "host deaf", "host silent",
      "clock jumped",         "disk full"};
  std::string text;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", names[kind], came_[kind]);
  }
  return text;
}

}  // namespace pizarra::bench
