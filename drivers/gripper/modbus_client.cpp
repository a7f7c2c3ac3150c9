#include "drivers/gripper/modbus_client.hpp"

#include <cassert>
#include <cerrno>
#include <fmt/format.h>
#include <modbus/modbus.h>
#include <mutex>

namespace pizarra::gripper {

namespace {

constexpr std::uint32_t answer_time_us = 300'000;

bool is_exception(int error) { return error >= EMBXILFUN && error <= EMBXGTAR; }
bool is_nonsense(int error) { return error >= EMBBADCRC && error <= EMBBADSLAVE; }

}  // namespace

// Shared with work that outlives who asked for it; one at a time has it.
struct ModbusClient::Connection {
  Connection(std::string the_host, int the_port, int the_unit)
      : host(std::move(the_host)), port(the_port), unit(the_unit) {}
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() { close(); }

  void close() {
    if (context == nullptr) return;
    modbus_close(context);
    modbus_free(context);
    context = nullptr;
  }
  bool open() {
    if (context != nullptr) return true;
    context = modbus_new_tcp_pi(host.c_str(), std::to_string(port).c_str());
    if (context == nullptr) return false;
    // Without a time for each octet the answer's own is for all of it.
    const bool connected = modbus_set_response_timeout(context, 0, answer_time_us) == 0 &&
                           modbus_set_byte_timeout(context, 0, 0) == 0 && modbus_set_slave(context, unit) == 0 &&
                           modbus_connect(context) == 0;
    const int why = errno;
    if (!connected) close();
    errno = why;
    return connected;
  }

  std::mutex mutex;
  const std::string host;
  const int port;
  const int unit;
  modbus_t* context = nullptr;
};

struct ModbusClient::Exchange {
  int first;
  std::vector<std::uint16_t> values;  // to be written, or as they were read
  bool writes;
  int error = 0;  // what errno said
  std::string trouble = {};

  void run(Connection& connection) {
    const std::lock_guard<std::mutex> alone(connection.mutex);
    const int count = static_cast<int>(values.size());
    int done = -1;
    if (connection.open()) {
      done = writes ? modbus_write_registers(connection.context, first, count, values.data())
                    : modbus_read_registers(connection.context, first, count, values.data());
    }
    if (done == count) return;
    error = errno;
    trouble = modbus_strerror(error);
    // A late answer would be taken for the next one.
    if (!is_exception(error)) connection.close();
  }

  Failure failure(const Connection& connection) const {
    const std::string where = fmt::format("{} port {}", connection.host, connection.port);
    if (is_exception(error)) {
      const int code = error - MODBUS_ENOBASE;
      return {"refused",
              fmt::format("{} refused registers from {} on: {} ({})", where, first, trouble, code),
              to_datum(code),
              {}};
    }
    if (is_nonsense(error)) {
      return {"bad-reply", fmt::format("{} answered what is no answer: {}", where, trouble), to_datum(first), {}};
    }
    if (error == ETIMEDOUT) {
      return {"disconnected", fmt::format("{} does not answer", where), to_datum(connection.host), {}};
    }
    return {"disconnected", fmt::format("{} is not reached: {}", where, trouble), to_datum(connection.host), {}};
  }
};

ModbusClient::ModbusClient(Executor& executor, std::string host, int port, int unit)
    : executor_(executor), connection_(std::make_shared<Connection>(std::move(host), port, unit)), turns_(executor) {}

ModbusClient::~ModbusClient() = default;

Task<Result<std::vector<std::uint16_t>>> ModbusClient::carry_out(std::shared_ptr<Exchange> exchange) {
  const Turns::Turn turn = co_await turns_.take();
  const std::shared_ptr<Connection> connection = connection_;
  std::function<void(const std::function<bool()>&)> work = [exchange,
                                                            connection](const std::function<bool()>& cancelled) {
    if (!cancelled()) exchange->run(*connection);
  };
  co_await executor_.offload(std::move(work), Duration::zero());
  if (exchange->error != 0) co_return fail(exchange->failure(*connection));
  co_return std::move(exchange->values);
}

Task<Result<std::vector<std::uint16_t>>> ModbusClient::read(int first, std::size_t count) {
  assert(count > 0 && count <= most_registers);
  return carry_out(std::make_shared<Exchange>(Exchange{first, std::vector<std::uint16_t>(count), false}));
}

Task<Result<void>> ModbusClient::write(int first, std::vector<std::uint16_t> values) {
  assert(!values.empty() && values.size() <= most_registers);
  auto exchange = std::make_shared<Exchange>(Exchange{first, std::move(values), true});
  const Result<std::vector<std::uint16_t>> done = co_await carry_out(std::move(exchange));
  if (!done) co_return fail(done);
  co_return Result<void>();
}

}  // namespace pizarra::gripper
