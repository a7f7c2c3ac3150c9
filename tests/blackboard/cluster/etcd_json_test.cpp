// What etcd answers is judged before it is believed.

#include "blackboard/cluster/etcd_json.hpp"

#include <gtest/gtest.h>

namespace pizarra::cluster {
namespace {

TEST(EtcdJson, OfAnotherTypeThanExpectedIsAFailure) {
  for (const std::string wrong : {
           R"({"header":{},"succeeded":"yes"})",
           R"({"header":{},"responses":{"a":1}})",
           R"({"header":{},"responses":[7]})",
           R"({"header":{},"responses":[{"response_range":7}]})",
           R"({"header":{},"responses":[{"response_range":{"kvs":[7]}}]})",
           R"({"header":{},"responses":[{"response_range":{"kvs":{"key":7}}}]})",
       }) {
    const Result<KeyValues::Reply> reply = etcd_json::reply_from(wrong);
    ASSERT_FALSE(reply) << wrong;
    EXPECT_EQ(reply.error().symbol, "unavailable") << wrong;
  }
  for (const std::string wrong : {R"({"header":{},"kvs":7})", R"({"header":{},"kvs":["x"]})"}) {
    EXPECT_FALSE(etcd_json::range_from(wrong)) << wrong;
  }
  for (const std::string wrong :
       {R"({"alarms":7})", R"({"alarms":[7]})", R"({"alarms":[{"memberID":"1","alarm":7}]})"}) {
    EXPECT_FALSE(etcd_json::disarming(wrong)) << wrong;
  }
  for (const std::string wrong : {R"([{"id":1,"peerURLs":7}])", R"([{"id":1,"peerURLs":[7]}])"}) {
    EXPECT_FALSE(etcd_json::members_from(wrong)) << wrong;
  }
}

TEST(EtcdJson, LacksWhatIsFalseOrEmpty) {
  const Result<KeyValues::Reply> refused = etcd_json::reply_from(R"({"header":{}})");
  ASSERT_TRUE(refused);
  EXPECT_FALSE(refused->succeeded);
  EXPECT_TRUE(etcd_json::disarming("{}").value().empty());
  EXPECT_EQ(etcd_json::disarming(R"({"alarms":[{"memberID":"1","alarm":"NOSPACE"},{"memberID":"2"}]})")->size(), 1u);
  EXPECT_EQ(etcd_json::members_from(R"([{"id":1}])")->size(), 1u);
}

TEST(EtcdJson, OfALogIsToldInWords) {
  EXPECT_EQ(
      etcd_json::news_from(R"({"level":"fatal","ts":"2026-11-27T19:00:22.285Z","caller":"backend/batch_tx.go:248",)"
                           R"("msg":"failed to commit tx","error":"write /d/member/snap/db: no space left on )"
                           R"(device","stacktrace":"go.etcd.io/etcd/mvcc/backend.(*batchTx).commit"})"),
      "failed to commit tx: write /d/member/snap/db: no space left on device");
  EXPECT_EQ(etcd_json::news_from(R"({"level":"warn","msg":"closed"})"), "closed");
  EXPECT_EQ(etcd_json::news_from("pizarra: etcd is not installed"), "pizarra: etcd is not installed");
  EXPECT_EQ(etcd_json::error_from("404 page not found\n"), "404 page not found");
}

}  // namespace
}  // namespace pizarra::cluster
