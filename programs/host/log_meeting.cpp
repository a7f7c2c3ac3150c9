#include "programs/host/log_meeting.hpp"

#include <fstream>
#include <iterator>

namespace pizarra::host {

namespace {

constexpr const char* place_of_word = "/no-data";
constexpr Duration answers_within = 500ms;

std::string word_of(const cluster::LogAddress& log) { return "(no-data " + log.cell + ")\n"; }

Result<std::string> pem(const cluster::LogAddress& log, const char* name) {
  if (log.certificates.empty()) return std::string();
  const std::string path = log.certificates + "/" + name;
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (text.empty()) return fail("bad-address", "the certificates of the log cannot be read: " + path);
  return text;
}

}  // namespace

Result<std::unique_ptr<web::HttpServer>> say_no_data(Executor& executor, const std::string& own,
                                                     const cluster::LogAddress& log) {
  const Result<std::string> certificate = pem(log, "server.crt");
  if (!certificate) return fail(certificate);
  const Result<std::string> key = pem(log, "server.key");
  if (!key) return fail(key);
  const cluster::HostPort at = cluster::host_and_port(own);
  return web::HttpServer::listen(executor,
                                 {.address = at.host == "localhost" ? "127.0.0.1" : at.host,
                                  .port = at.port,
                                  .certificate = *certificate,
                                  .certificate_key = *key},
                                 [word = word_of(log)](const web::HttpRequest& request) {
                                   if (request.path != place_of_word) return web::HttpAnswer{.status = 404};
                                   return web::HttpAnswer{.type = "text/plain", .body = word};
                                 });
}

Result<bool> says_no_data(cluster::EtcdClient& between, std::size_t member, const cluster::LogAddress& log) {
  const Result<std::string> said = between.read(member, place_of_word, answers_within);
  if (!said) return fail(said);
  return *said == word_of(log);
}

}  // namespace pizarra::host
