#pragma once

// Requests to etcd's gateway and its answers, as JSON. Keys and values stand there as base64.
//
//   const std::string body = etcd_json::request(transaction);          // to POST to /v3/kv/txn
//   Result<KeyValues::Reply> reply = etcd_json::reply_from(answer);

#include <string>

#include "blackboard/cluster/key_values.hpp"
#include "blackboard/cluster/log_members.hpp"

namespace pizarra::cluster::etcd_json {

std::string request(const KeyValues::Transaction& transaction);
std::string request(const KeyValues::Range& range, std::size_t most);
// Failure unavailable where it is not understood.
Result<KeyValues::Reply> reply_from(const std::string& body);
Result<std::vector<KeyValue>> range_from(const std::string& body);
// Of the answer to a question for a member's status; the quota is not in it.
Result<KeyValues::Space> space_from(const std::string& body);
Result<std::string> revision_from(const std::string& body);
std::string compaction(const std::string& revision);
// The requests that end each alarm for lack of space that an answer lists.
Result<std::vector<std::string>> disarming(const std::string& body);
Result<std::vector<LogMember>> members_from(const std::string& body);
std::string removal(std::uint64_t member);
std::string addition(const std::string& peer_url);
// What an error says, or a beginning of it.
std::string error_from(const std::string& body);
// The message in a line of etcd's own log, without time, level and stack. Any other line is answered as it is.
std::string news_from(const std::string& log_line);

}  // namespace pizarra::cluster::etcd_json
