#include "tests/bench/blackboard/redis.hpp"

#include <stdexcept>

#include "lisp/installed_program.hpp"
#include "tests/free_port.hpp"

namespace pizarra::bench {

std::optional<RedisServer> RedisServer::start(const std::vector<std::string>& options) {
  const std::optional<std::string> program = installed_program("redis-server");
  if (!program) return std::nullopt;
  TemporaryFolder folder;
  const int port = free_port();
  std::vector<std::string> command = {
      *program, "--port", std::to_string(port), "--bind", "127.0.0.1", "--dir", folder.path(), "--save", ""};
  command.insert(command.end(), options.begin(), options.end());
  Child process = Child::program(command);
  while (process.pipe().hear_line().find("Ready to accept connections") == std::string::npos) {
  }
  return RedisServer(std::move(folder), std::move(process), port);
}

std::string RedisClient::command(std::initializer_list<std::string_view> words) {
  std::string text = "*" + std::to_string(words.size()) + "\r\n";
  for (const std::string_view word : words) {
    text += "$" + std::to_string(word.size()) + "\r\n";
    text += word;
    text += "\r\n";
  }
  return text;
}

void RedisClient::receive(int replies) {
  for (int i = 0; i < replies; ++i) {
    const std::string_view first = link_.line();
    if (first.starts_with("-")) throw std::runtime_error("redis refuses: " + std::string(first));
    if (first.starts_with("$")) link_.line();
  }
}

std::string RedisClient::message() {
  // *3, then length and text of each.
  for (int lines = 0; lines < 6; ++lines) link_.line();
  return std::string(link_.line());
}

}  // namespace pizarra::bench
