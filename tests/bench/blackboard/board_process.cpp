#include "tests/bench/blackboard/board_process.hpp"

#include <fmt/format.h>

#include "lisp/reader.hpp"

namespace pizarra::bench {

namespace {

std::vector<std::string> command_with(const std::vector<std::string>& options) {
  std::vector<std::string> command = {program_beside("pizarra-board"), "--listen", "tcp://127.0.0.1:*"};
  command.insert(command.end(), options.begin(), options.end());
  return command;
}

}  // namespace

BoardProcess::BoardProcess(const std::vector<std::string>& options) : process_(Child::program(command_with(options))) {
  const std::string ready = process_.pipe().hear_line();
  address_ = ready.substr(ready.rfind(' ') + 1);
}

Client::Client(const std::string& address, const std::string& name)
    : board_(client::RemoteBoard::connect(executor_, address, name).value()) {
  const std::vector<Relation> relations = {object_relation()};
  run(board_->declare(relations));
}

void Client::run(Task<void> task) {
  const Job job = executor_.spawn(std::move(task));
  executor_.run_until([&] { return job.done(); });
}

Relation object_relation() {
  return relation_from_datum(
             read_one("(relation seen ((name string) (x number) (y number) (d number)) (key name))").value())
      .value();
}

Datum object_name(int object) { return to_datum(fmt::format("object-{:06}", object)); }

Datum object_fact(int object, int count) {
  return list("seen"_sym, object_name(object), 100.25 + count % 100, 87.5, to_datum(count % 10'000));
}

double now_us() {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace pizarra::bench
