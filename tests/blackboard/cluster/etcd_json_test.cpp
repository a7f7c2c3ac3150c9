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

}  // namespace
}  // namespace pizarra::cluster
