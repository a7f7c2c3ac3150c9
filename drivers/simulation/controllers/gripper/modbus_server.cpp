#include "drivers/simulation/controllers/gripper/modbus_server.hpp"

#include <modbus/modbus.h>
#include <sys/socket.h>
#include <unistd.h>

#include "drivers/line/tcp_port.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::uint32_t pieces_us = 100'000;
constexpr std::size_t function_at = 7;  // behind the header
constexpr std::uint8_t write_one = 6;
constexpr std::uint8_t write_several = 16;

}  // namespace

// Its context, and registers from the first to the last of the gripper's, with what lies between.
struct ModbusServer::Protocol {
  explicit Protocol(const GripperEmulator& gripper) : context(modbus_new_tcp("127.0.0.1", 0)) {
    const int first = std::min(gripper.orders().first(), gripper.states().first());
    const int last = std::max(last_of(gripper.orders()), last_of(gripper.states()));
    mapping = modbus_mapping_new_start_address(0, 0, 0, 0, static_cast<unsigned>(first),
                                               static_cast<unsigned>(last - first + 1), 0, 0);
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
  std::uint16_t* place_of(const gripper::RegisterImage& image) const {
    return mapping->tab_registers + (image.first() - mapping->start_registers);
  }
  void show(const gripper::RegisterImage& image) const { std::ranges::copy(image.values(), place_of(image)); }
  gripper::RegisterImage seen(const gripper::RegisterImage& image) const {
    const std::uint16_t* begin = place_of(image);
    return {image.first(), std::vector<std::uint16_t>(begin, begin + image.values().size())};
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

void ModbusServer::serve() {
  std::uint8_t request[MODBUS_TCP_MAX_ADU_LENGTH];
  const int size = modbus_receive(protocol_->context, request);
  if (size < 0) return hang_up();
  if (size == 0 || !gripper_.powered()) return;
  if (gripper_.exception() != 0) {
    modbus_reply_exception(protocol_->context, request, static_cast<unsigned>(gripper_.exception()));
    return;
  }
  protocol_->show(gripper_.orders());
  protocol_->show(gripper_.states());
  if (modbus_reply(protocol_->context, request, size, protocol_->mapping) < 0) return;
  const std::uint8_t function = request[function_at];
  if (function == write_one || function == write_several) gripper_.told(protocol_->seen(gripper_.orders()));
}

}  // namespace pizarra::simulation
