#include "drivers/simulation/controllers/gripper/modbus_server.hpp"

#include <modbus/modbus.h>
#include <optional>
#include <sys/socket.h>
#include <unistd.h>

#include "drivers/line/tcp_port.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::uint32_t pieces_us = 100'000;
constexpr std::size_t header = 7;  // the function comes behind it
constexpr std::uint8_t read_holding = 3;
constexpr std::uint8_t read_inputs = 4;
constexpr std::uint8_t write_one = 6;
constexpr std::uint8_t write_several = 16;
constexpr std::uint8_t write_and_read = 23;
constexpr unsigned wrong_address = 2;  // exceptions
constexpr unsigned wrong_value = 3;

// The values to be written, and the first register.
struct Write {
  int first = 0;
  std::vector<std::uint16_t> values = {};
};

std::uint16_t word_at(std::span<const std::uint8_t> request, std::size_t at) {
  return at + 1 < request.size() ? static_cast<std::uint16_t>(request[at] << 8 | request[at + 1]) : std::uint16_t{0};
}

// None where its counts contradict each other.
std::optional<Write> write_in(std::span<const std::uint8_t> request) {
  const std::uint8_t function = request[header];
  if (function == write_one) return Write{word_at(request, header + 1), {word_at(request, header + 3)}};
  // A request that reads too says first from where.
  const std::size_t at = function == write_several ? header + 1 : header + 5;
  Write write{.first = word_at(request, at)};
  const std::size_t count = word_at(request, at + 2);
  const std::size_t data = at + 5;
  if (request.size() < data || request[data - 1] != 2 * count || request.size() != data + 2 * count) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < count; ++i) write.values.push_back(word_at(request, data + 2 * i));
  return write;
}

bool within(const gripper::RegisterImage& image, int first, std::size_t count) {
  return count > 0 && first >= image.first() &&
         static_cast<std::size_t>(first - image.first()) + count <= image.values().size();
}

// The same registers from 0 on, where a maker's network module has them.
gripper::RegisterImage from_zero(const gripper::RegisterImage& image) { return {0, image.values()}; }

}  // namespace

// Its context, and all registers that it can answer from: those to write and read, and those to read alone.
struct ModbusServer::Protocol {
  explicit Protocol(const GripperEmulator& gripper) : context(modbus_new_tcp("127.0.0.1", 0)) {
    const int last = std::max(last_of(gripper.orders()), last_of(gripper.states()));
    mapping = modbus_mapping_new(0, 0, last + 1, last + 1);
    modbus_set_indication_timeout(context, 0, pieces_us);
    modbus_set_byte_timeout(context, 0, pieces_us);
  }
  Protocol(const Protocol&) = delete;
  Protocol& operator=(const Protocol&) = delete;
  ~Protocol() {
    modbus_mapping_free(mapping);
    modbus_free(context);
  }

  static int last_of(const gripper::RegisterImage& image) {
    return image.first() + static_cast<int>(image.values().size()) - 1;
  }
  void show(const GripperEmulator& gripper) const {
    std::uint16_t* both = mapping->tab_registers;
    std::uint16_t* inputs = mapping->tab_input_registers;
    std::ranges::copy(gripper.orders().values(), both);
    std::ranges::copy(gripper.orders().values(), both + gripper.orders().first());
    std::ranges::copy(gripper.states().values(), both + gripper.states().first());
    std::ranges::copy(gripper.states().values(), inputs);
    std::ranges::copy(gripper.states().values(), inputs + gripper.states().first());
  }

  modbus_t* context;
  modbus_mapping_t* mapping;
};

Result<std::unique_ptr<ModbusServer>> ModbusServer::listen(Executor& executor, GripperEmulator& gripper,
                                                           const std::string& address, std::uint16_t port) {
  const Result<line::Listening> listening = line::listen_at(address, port);
  if (!listening) return fail(listening);
  return std::unique_ptr<ModbusServer>(new ModbusServer(executor, gripper, listening->file, listening->port));
}

ModbusServer::ModbusServer(Executor& executor, GripperEmulator& gripper, int listener, std::uint16_t port)
    : executor_(executor),
      gripper_(gripper),
      listener_(listener),
      port_(port),
      protocol_(std::make_unique<Protocol>(gripper)) {
  executor_.watch_readable(listener_, [this] { welcome(); });
}

ModbusServer::~ModbusServer() {
  hang_up();
  executor_.unwatch_readable(listener_);
  ::close(listener_);
}

// Who comes while another is there takes its place: one that was cut off is not waited for.
void ModbusServer::welcome() {
  const int come = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
  if (come < 0) return;
  hang_up();
  client_ = come;
  modbus_set_socket(protocol_->context, client_);
  executor_.watch_readable(client_, [this] { serve(); });
}

void ModbusServer::hang_up() {
  if (client_ < 0) return;
  executor_.unwatch_readable(client_);
  ::close(std::exchange(client_, -1));
}

// What it is told to write is written; the exception that it answers with, 0 for none.
unsigned ModbusServer::obey(std::span<const std::uint8_t> request) {
  const std::uint8_t function = request[header];
  if (function == write_one || function == write_several || function == write_and_read) {
    const std::optional<Write> write = write_in(request);
    if (!write) return wrong_value;
    const gripper::RegisterImage& orders = gripper_.orders();
    const int shift = within(orders, write->first, write->values.size()) ? 0 : orders.first();
    if (!within(orders, write->first + shift, write->values.size())) return wrong_address;
    std::vector<std::uint16_t> values = orders.values();
    std::ranges::copy(write->values, values.begin() + (write->first + shift - orders.first()));
    gripper_.told(gripper::RegisterImage(orders.first(), std::move(values)));
    if (function != write_and_read) return 0;
  }
  const int first = word_at(request, header + 1);
  const std::size_t count = word_at(request, header + 3);
  const auto has = [&](const gripper::RegisterImage& image) { return within(image, first, count); };
  const bool state = has(gripper_.states()) || (function == read_inputs && has(from_zero(gripper_.states())));
  const bool order = function != read_inputs && (has(gripper_.orders()) || has(from_zero(gripper_.orders())));
  return state || order ? 0 : wrong_address;
}

void ModbusServer::serve() {
  std::uint8_t octets[MODBUS_TCP_MAX_ADU_LENGTH];
  const int size = modbus_receive(protocol_->context, octets);
  if (size < 0) return hang_up();
  if (size == 0 || !gripper_.powered()) return;
  unsigned exception = static_cast<unsigned>(gripper_.exception());
  const std::uint8_t function = octets[header];
  // libmodbus says of other functions what they may have.
  const bool about_registers = function == read_holding || function == read_inputs || function == write_one ||
                               function == write_several || function == write_and_read;
  if (exception == 0 && about_registers) exception = obey({octets, static_cast<std::size_t>(size)});
  if (exception != 0) {
    modbus_reply_exception(protocol_->context, octets, exception);
    return;
  }
  protocol_->show(gripper_);
  modbus_reply(protocol_->context, octets, size, protocol_->mapping);
}

}  // namespace pizarra::simulation
