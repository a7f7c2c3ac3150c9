// A log is of one cell, whichever board of it comes first.

#include "blackboard/cluster/log_owner.hpp"

#include <gtest/gtest.h>

#include "tests/blackboard/cluster/etcd_model.hpp"

namespace pizarra::cluster {
namespace {

class LogOwners : public testing::Test {
 protected:
  LogOwners() { etcd_.trouble = 0; }
  // "mine", or why not.
  std::string claim(const LogOwner& owner) {
    const Result<void> claimed = claim_log(client_, LogKeys("blocks"), owner);
    return claimed ? "mine" : claimed.error().sentence;
  }
  EtcdModel etcd_{1};
  ModelClient client_{etcd_};
};

TEST_F(LogOwners, AreTheCellWhoseBoardCameFirst) {
  EXPECT_EQ(claim({"blocks"}), "mine");
  EXPECT_EQ(claim({"blocks"}), "mine");
  EXPECT_EQ(claim({"kits"}),
            "this log has the facts of the cell blocks, and this is a board of the cell kits: give each cell a name of "
            "its own behind the last slash of --log");
}

TEST_F(LogOwners, OfOneNameAreToldApartByTheKeyOfTheirBoards) {
  EXPECT_EQ(claim({"blocks", "key-1"}), "mine");
  const std::string refusal =
      "this log has the facts of a cell blocks whose boards have another key than this one: give each cell a name of "
      "its own behind the last slash of --log";
  EXPECT_EQ(claim({"blocks", "key-2"}), refusal);
  EXPECT_EQ(claim({"blocks"}), refusal);
  EXPECT_EQ(claim({"blocks", "key-1"}), "mine");
}

TEST_F(LogOwners, MayGetAKeyLater) {
  EXPECT_EQ(claim({"blocks"}), "mine");
  EXPECT_EQ(claim({"blocks", "key-1"}), "mine");
  EXPECT_NE(claim({"blocks", "key-2"}), "mine");
}

}  // namespace
}  // namespace pizarra::cluster
