#pragma once

// Puts an emulated gripper at a Modbus TCP port, by libmodbus. Its answers can be read as input or holding registers.
// Its orders can be read and written as holding registers, some or all of them; functions 3, 4, 6, 16 and 23. Both are
// also there from register 0 on, as Robotiq's network modules have them. One client at a time, whatever unit it asks
// for.
//
//   Result<std::unique_ptr<ModbusServer>> server = ModbusServer::listen(executor, gripper, "127.0.0.1", 0);
//   (*server)->port();
//
// A request that comes in pieces is waited for, a tenth of a second at most.

#include <memory>
#include <span>

#include "drivers/simulation/controllers/gripper/gripper_emulator.hpp"

namespace pizarra::simulation {

class ModbusServer {
 public:
  // The gripper outlives it. Failure: bad-address.
  static Result<std::unique_ptr<ModbusServer>> listen(Executor& executor, GripperEmulator& gripper,
                                                      const std::string& address, std::uint16_t port);
  ~ModbusServer();
  ModbusServer(const ModbusServer&) = delete;
  ModbusServer& operator=(const ModbusServer&) = delete;
  std::uint16_t port() const { return port_; }
  // Hangs up on whoever is there.
  void hang_up();

 private:
  struct Protocol;
  ModbusServer(Executor& executor, GripperEmulator& gripper, int listener, std::uint16_t port);
  void welcome();
  void serve();
  unsigned obey(std::span<const std::uint8_t> request);

  Executor& executor_;
  GripperEmulator& gripper_;
  int listener_;
  std::uint16_t port_;
  int client_ = -1;
  std::unique_ptr<Protocol> protocol_;
};

}  // namespace pizarra::simulation
