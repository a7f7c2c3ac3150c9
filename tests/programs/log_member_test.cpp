// `log member`: members of a log, with certificates, begin together and come back without their data.

#include <arpa/inet.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/blackboard/cluster/real_etcd.hpp"
#include "tests/certificates.hpp"
#include "tests/free_port.hpp"
#include "tests/has_ipv6.hpp"
#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"

namespace pizarra::programs {
namespace {

using std::chrono::seconds;

// Three hosts of one machine.
class LogMembers : public testing::Test {
 protected:
  void SetUp() override {
    if (!cluster::RealEtcd::is_installed()) GTEST_SKIP() << "etcd is not installed (etcd-server)";
    if (!make_certificates(own_) || !make_certificates(strange_)) GTEST_SKIP() << "openssl is not installed (openssl)";
    are_at("127.0.0.1");
  }
  void are_at(const std::string& address) {
    for (const char* host : {"a", "b", "c"}) {
      ports_[host] = two_free_ports();
      members_[host] = fmt::format("{}:{}", address, ports_[host]);
      std::filesystem::remove_all(folder(host));
    }
  }
  static std::string folder(const std::string& host) { return scratch_folder() + "log-member-" + host; }
  std::string log() const {
    return fmt::format("etcd://{},{},{}/here", members_.at("a"), members_.at("b"), members_.at("c"));
  }
  void start(const std::string& host, const std::string& certificates) {
    std::vector<std::string> words = {PIZARRA_CELL, "log", "member", log(), members_.at(host), folder(host)};
    if (!certificates.empty()) words.insert(words.end(), {"--log-certificates", certificates});
    running_[host] = std::make_unique<Running>(words, scratch_folder() + "log-member-" + host + ".log");
  }
  bool comes_up(const std::string& host) const {
    const std::string ask =
        fmt::format("curl -s --cacert {0}/ca.crt --cert {0}/client.crt --key {0}/client.key https://{1}/health", own_,
                    members_.at(host));
    return wait_until([&] { return shell_in_scratch(ask).text.contains("true"); }, seconds(60));
  }
  std::string said() const {
    std::string all;
    for (const auto& [host, member] : running_) all += "--- " + host + "\n" + member->said();
    return all;
  }
  void begin_and_bring_one_back() {
    for (const char* host : {"a", "b", "c"}) start(host, own_);
    for (const char* host : {"a", "b", "c"}) ASSERT_TRUE(comes_up(host)) << said();
    running_.at("c")->signal(SIGTERM);
    ASSERT_TRUE(running_.at("c")->end(seconds(60)).has_value());
    std::filesystem::remove_all(folder("c"));
    start("c", own_);
    EXPECT_TRUE(comes_up("c")) << said();
  }

  const std::string own_ = scratch_folder() + "own-certificates";
  const std::string strange_ = scratch_folder() + "strange-certificates";
  std::map<std::string, int> ports_;
  std::map<std::string, std::string> members_;
  std::map<std::string, std::unique_ptr<Running>> running_;
};

TEST_F(LogMembers, WithCertificatesBeginTogetherAndComeBackWithoutTheirData) { begin_and_bring_one_back(); }

TEST_F(LogMembers, OfIpv6BeginTogetherAndComeBackWithoutTheirData) {
  if (!has_ipv6()) GTEST_SKIP() << "this machine has no IPv6";
  are_at("[::1]");
  begin_and_bring_one_back();
}

TEST_F(LogMembers, TakeNobodysWordForHavingNoDataWhomTheirAuthorityDoesNotKnow) {
  for (const std::string& others : {strange_, std::string()}) {
    running_.clear();
    for (const char* host : {"a", "b"}) start(host, own_);
    start("c", others);
    // Of the three, b alone is believed.
    const std::string sentence = fmt::format("has no data, and waits for 127.0.0.1:{}:", ports_.at("c") + 1);
    const auto is_said = [&] { return running_.at("a")->said().contains(sentence); };
    EXPECT_TRUE(wait_until(is_said, seconds(60))) << said();
    const auto reason_is_said = [&] { return running_.at("a")->said().contains("its certificate is not believed: "); };
    EXPECT_TRUE(others.empty() || wait_until(reason_is_said, seconds(60))) << said();
    EXPECT_FALSE(std::filesystem::exists(folder("a") + "/member")) << "it did not begin";
  }
}

// Etcd itself would say these in stack traces.
class LogMemberWithoutAPlace : public LogMembers {
 protected:
  static Said member(const std::string& log, const std::string& here, const std::string& more) {
    return shell_in_scratch(fmt::format("{} log member etcd://{}/here {} {}", PIZARRA_CELL, log, here, more));
  }
};

TEST_F(LogMemberWithoutAPlace, IsToldThatAnotherCellsMemberHasItsPort) {
  const Running other(
      {PIZARRA_CELL, "log", "member", "etcd://" + members_.at("a") + "/other", members_.at("a"), folder("a")},
      scratch_folder() + "other-member.log");
  ASSERT_TRUE(wait_until([&] { return can_connect(ports_.at("a")); }, seconds(60))) << other.said();
  const Said refused = member(members_.at("a"), members_.at("a"), folder("b"));
  EXPECT_EQ(refused.status, 4) << refused.text;
  const std::string sentence = members_.at("a") +
                               " is taken. Where another cell's member runs there, leave out "
                               "--log-here: one log serves several cells. Or give the members of this log other ports";
  EXPECT_TRUE(refused.text.contains(sentence)) << refused.text;
  const std::string below = fmt::format("127.0.0.1:{}", ports_.at("a") - 1);
  const Said between = member(below, below, folder("b"));
  EXPECT_TRUE(between.text.contains(members_.at("a") + " is taken")) << "its port between members: " << between.text;
}

TEST_F(LogMemberWithoutAPlace, IsToldThatItsMachineHasAnotherAddress) {
  const Said refused = member("198.51.100.1", "198.51.100.1", folder("b") + " --log-insecure");
  EXPECT_EQ(refused.status, 2) << refused.text;
  EXPECT_TRUE(refused.text.contains("198.51.100.1 is no address of this machine")) << refused.text;
}

TEST_F(LogMemberWithoutAPlace, IsToldWhyItsFolderCannotBeMade) {
  std::ofstream(scratch_folder() + "file") << "in place of a folder";
  const Said refused = member(members_.at("a"), members_.at("a"), scratch_folder() + "file/member");
  EXPECT_EQ(refused.status, 4) << refused.text;
  EXPECT_TRUE(refused.text.contains("file/member: Not a directory")) << refused.text;
}

TEST_F(LogMemberWithoutAPlace, IsToldWhichCertificateIsMissing) {
  std::filesystem::remove(own_ + "/server.key");
  const Said refused = member(members_.at("a"), members_.at("a"), folder("b") + " --log-certificates " + own_);
  EXPECT_EQ(refused.status, 2) << refused.text;
  EXPECT_TRUE(refused.text.contains(own_ + "/server.key: No such file or directory")) << refused.text;
}

TEST_F(LogMemberWithoutAPlace, FindsEtcdWhereItsPathHasIt) {
  const std::string own = scratch_folder() + "bin";
  std::filesystem::create_directories(own);
  std::ofstream(own + "/etcd") << "#!/bin/sh\necho an etcd of my own\n";
  std::filesystem::permissions(own + "/etcd", std::filesystem::perms::owner_all);
  const Said said = shell_in_scratch(fmt::format("PATH={}:$PATH {} log member etcd://{}/here {} {}", own, PIZARRA_CELL,
                                                 members_.at("a"), members_.at("a"), folder("b")));
  EXPECT_TRUE(said.text.contains("an etcd of my own")) << said.text;
}

TEST_F(LogMembers, HaveAnAddressInFigures) {
  const Said refused = shell_in_scratch(std::string(PIZARRA_CELL) + " log member etcd://pc-1,pc-2,pc-3/here pc-2 " +
                                        folder("b") + " --log-insecure");
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(refused.text.contains("a member that runs here has an address in figures, not pc-2")) << refused.text;
}

}  // namespace
}  // namespace pizarra::programs
