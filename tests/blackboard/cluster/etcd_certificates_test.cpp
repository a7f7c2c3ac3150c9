// An etcd that speaks only to whom it knows by a certificate.

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

#include "blackboard/cluster/etcd_client.hpp"
#include "tests/blackboard/cluster/real_etcd.hpp"
#include "tests/certificates.hpp"
#include "tests/scratch.hpp"

namespace pizarra::cluster {
namespace {

class EtcdWithCertificates : public testing::Test {
 protected:
  void SetUp() override {
    if (!RealEtcd::is_installed()) GTEST_SKIP() << "etcd is not installed (etcd-server)";
    if (std::system("openssl version >/dev/null 2>&1") != 0) GTEST_SKIP() << "openssl is not installed (openssl)";
    ASSERT_TRUE(make_certificates(own_));
    ASSERT_TRUE(make_certificates(strange_));
    etcd_ = std::make_unique<RealEtcd>(own_);
  }
  std::unique_ptr<EtcdClient> client(const std::string& certificates) const {
    return EtcdClient::open(LogAddress::from(etcd_->address("cell"), certificates, true).value()).value();
  }
  // Tried until etcd listens.
  static Result<KeyValues::Reply> put(EtcdClient& client, std::chrono::seconds patience) {
    const auto end = std::chrono::steady_clock::now() + patience;
    Result<KeyValues::Reply> put = fail("unavailable", "not tried");
    while (!put && std::chrono::steady_clock::now() < end) {
      put = client.transact({.compares = {}, .puts = {{"a", "1"}}}, 1s);
    }
    return put;
  }

  const std::string own_ = scratch_folder() + "own-certificates";
  const std::string elsewhere_ = scratch_folder() + "certificates-of-elsewhere";
  const std::string strange_ = scratch_folder() + "strange-certificates";
  std::unique_ptr<RealEtcd> etcd_;
};

TEST_F(EtcdWithCertificates, AnswersAClientThatItKnowsAndNobodyElse) {
  const Result<KeyValues::Reply> known = put(*client(own_), std::chrono::seconds(60));
  ASSERT_TRUE(known.has_value()) << describe(known.error());
  const Result<KeyValues::Reply> strange = client(strange_)->transact({.compares = {}, .puts = {{"a", "2"}}}, 5s);
  ASSERT_FALSE(strange.has_value());
  EXPECT_EQ(strange.error().symbol, "unavailable");
  // One that trusts the server, but has no certificate of its authority.
  std::filesystem::copy_file(own_ + "/ca.crt", strange_ + "/ca.crt", std::filesystem::copy_options::overwrite_existing);
  EXPECT_FALSE(client(strange_)->transact({.compares = {}, .puts = {{"a", "2"}}}, 5s).has_value());
  EXPECT_FALSE(client("")->transact({.compares = {}, .puts = {{"a", "2"}}}, 5s).has_value()) << "unencrypted";
  EXPECT_EQ(get(*client(own_), "a", 5s).value(), "1");
}

TEST_F(EtcdWithCertificates, AsksAClientWithoutOneForTheFolderOfCertificates) {
  ASSERT_TRUE(put(*client(own_), std::chrono::seconds(60)).has_value());
  const Result<KeyValues::Reply> bare = client("")->transact({.compares = {}, .puts = {{"a", "2"}}}, 5s);
  ASSERT_FALSE(bare.has_value());
  EXPECT_TRUE(bare.error().sentence.contains("--log-certificates")) << bare.error().sentence;
}

// A board asks ten times a second, and nothing bounds that log.
TEST_F(EtcdWithCertificates, WritesNoLineOfItsLogForARequest) {
  ASSERT_TRUE(put(*client(own_), std::chrono::seconds(60)).has_value());
  for (int request = 0; request < 5; ++request) ASSERT_TRUE(get(*client(own_), "a", 5s).has_value());
  const std::string said = etcd_->said();
  EXPECT_TRUE(said.contains("serving client requests")) << said;
  EXPECT_FALSE(said.contains("proxy request")) << said;
}

TEST_F(EtcdWithCertificates, IsSaidToBeAnotherWhereItsCertificateIsOfAnotherAddressOrAuthority) {
  ASSERT_TRUE(put(*client(own_), std::chrono::seconds(60)).has_value());
  const auto refused = [](const std::unique_ptr<EtcdClient>& client) {
    const auto answer = client->transact({.compares = {}, .puts = {{"a", "2"}}}, 5s);
    return answer ? Failure() : answer.error();
  };
  const Failure authority = refused(client(strange_));
  EXPECT_TRUE(is_distrusted(authority)) << describe(authority);
  EXPECT_TRUE(authority.sentence.contains(": its certificate is not believed: ")) << authority.sentence;
  ASSERT_TRUE(make_certificates(elsewhere_, "IP:10.0.0.1"));
  const RealEtcd etcd(elsewhere_);
  const auto other = EtcdClient::open(LogAddress::from(etcd.address("cell"), elsewhere_, true).value()).value();
  Failure address;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!is_distrusted(address) && std::chrono::steady_clock::now() < end) address = refused(other);
  EXPECT_TRUE(address.sentence.contains("127.0.0.1'")) << address.sentence;
}

TEST_F(EtcdWithCertificates, IsRefusedWhereAFileIsMissing) {
  std::filesystem::remove(own_ + "/client.key");
  const auto refused = EtcdClient::open(LogAddress::from(etcd_->address("cell"), own_, false).value());
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().symbol, "bad-address");
  EXPECT_TRUE(refused.error().sentence.contains("client.key")) << refused.error().sentence;
}

}  // namespace
}  // namespace pizarra::cluster
