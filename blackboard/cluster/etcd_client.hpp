#pragma once

// Etcd as the store under a cluster log, through its JSON gateway over HTTP/1.1.
//
//   Result<std::unique_ptr<EtcdClient>> etcd = EtcdClient::open(address);     // connects when first used
//   (*etcd)->transact({.compares = {{"a", std::nullopt}}, .puts = {{"a", "1"}}}, 200ms);
//
// The member on this host is asked first. One that does not answer in time is left for the next one. The connection
// stays.

#include <memory>
#include <optional>

#include "blackboard/cluster/key_values.hpp"
#include "blackboard/cluster/log_address.hpp"

namespace pizarra::cluster {

class EtcdClient : public KeyValues {
 public:
  // Failure bad-address where a file of the certificates cannot be read.
  static Result<std::unique_ptr<EtcdClient>> open(const LogAddress& address);
  ~EtcdClient() override;

  Result<Reply> transact(const Transaction& transaction, Duration wait) override;
  Result<std::vector<KeyValue>> range(const Range& range, std::size_t most, Duration wait) override;
  Result<Space> space(Duration wait) override;
  Result<void> forget_former(Duration wait) override;
  Result<void> close_holes(Duration wait) override;
  Result<void> end_refusing(Duration wait) override;

  // Reads a path of one member; posts to a path of any member. Failure unavailable.
  Result<std::string> read(std::size_t member, const char* path, Duration wait);
  Result<void> order(const char* path, const std::string& body, Duration wait);

 private:
  class Connection;
  explicit EtcdClient(const LogAddress& address);
  // The answer's body, of the member that answers requests.
  Result<std::string> post(const char* path, const std::string& body, Duration wait);
  Result<std::string> ask(std::size_t member, const char* path, const std::optional<std::string>& body, Duration wait);
  std::size_t answering_member();
  std::size_t next_member();
  Result<Space> space_of(std::size_t member, Duration wait);
  std::uint64_t quota(std::size_t member, Duration wait);

  const LogAddress address_;
  std::unique_ptr<Connection> connection_;
  std::optional<std::size_t> member_;  // found by the first request: names are resolved, which may take its time
};

}  // namespace pizarra::cluster
