#pragma once

// Every arm driver over its emulated controller in virtual time, with the same handles on the line between them: what
// all drivers must do is tested on all of these.
//
//   template <class Cell> class EveryArm : public testing::Test, protected Cell {};
//   TYPED_TEST_SUITE(EveryArm, DrivenCells);
//
// A cell has `executor`, `arm`, `cabinet`, model(), and
//   cut(true)            the line is cut, or mended
//   spoil(f)             what becomes of what the controller says; nullptr: nothing
//   begin_anew()         the driver is another, as in a process that was started again
//   orders()             how many octets or datagrams the controller was sent

#include <gtest/gtest.h>
#include <memory>

#include "drivers/arm/simple_message/simple_arm.hpp"
#include "drivers/arm/universal/universal_arm.hpp"
#include "drivers/simulation/controllers/arms/simple_emulator.hpp"
#include "drivers/simulation/controllers/arms/ur_emulator.hpp"
#include "tests/drivers/arm/motoman/host_cell.hpp"

namespace pizarra {

using Spoil = std::function<std::string(std::string)>;

template <class Driver, class... Given>
void replace(Driver& driver, Given&&... given) {
  std::destroy_at(&driver);
  std::construct_at(&driver, std::forward<Given>(given)...);
}

struct DrivenHses : HsesCell {
  static constexpr const char* name = "Hses";
  static const ArmModel& model() { return up6(); }
  void cut(bool now) { line.pulled = now; }
  void spoil(Spoil how) { line.from_device = std::move(how); }
  std::size_t orders() const { return line.sent; }
  void begin_anew() { replace(arm, executor, link, model()); }
};

template <class Cell>
struct DrivenHost : Cell {
  static constexpr const char* name = std::is_same_v<Cell, BscCell> ? "Bsc" : "EthernetServer";
  static const ArmModel& model() { return up6(); }
  void cut(bool now) { Cell::wire.cut(now); }
  void spoil(Spoil how) { Cell::wire.far.spoil = std::move(how); }
  std::size_t orders() const { return Cell::wire.near.written.size(); }
  void begin_anew() { replace(Cell::arm, Cell::executor, Cell::link, model()); }
};

// Several lines, all cut and spoilt together.
template <class Cell>
struct DrivenLines : DrivenArm<Cell> {
  void cut(bool now) {
    for (WirePair* line : lines()) line->cut(now);
  }
  void spoil(const Spoil& how) {
    for (WirePair* line : lines()) line->far.spoil = how;
  }
  std::size_t orders() {
    std::size_t octets = 0;
    for (WirePair* line : lines()) octets += line->near.written.size();
    return octets;
  }

 private:
  std::vector<WirePair*> lines() { return static_cast<Cell&>(*this).all_lines(); }
};

struct DrivenUniversal : DrivenLines<DrivenUniversal> {
  static constexpr const char* name = "Universal";
  static const ArmModel& model() {
    static const ArmModel ur5e = shipped_arm("ur5e").value();
    return ur5e;
  }
  std::vector<WirePair*> all_lines() { return {&rtde_line, &script_line, &dashboard_line}; }

  VirtualExecutor executor;
  MovingArm body{executor, model()};
  ArmCabinet cabinet{executor, body, model()};
  UrEmulator emulator{cabinet};
  WirePair rtde_line{executor};
  WirePair script_line{executor};
  WirePair dashboard_line{executor};
  Job telling{executor.spawn(serve_rtde(executor, emulator, rtde_line.far))};
  Job running{executor.spawn(serve_script(executor, emulator, script_line.far))};
  Job answering{executor.spawn(serve_dashboard(executor, emulator, dashboard_line.far))};
  UniversalWires wires{rtde_line.near, script_line.near, dashboard_line.near};
  UniversalArm arm{executor, wires, model()};
  void begin_anew() { replace(arm, executor, wires, model()); }
};

struct SimpleCell : DrivenLines<SimpleCell> {
  // Until its drives are on.
  explicit SimpleCell(const SimpleKind& kind_of_line) : kind(kind_of_line) { executor.run_for(300ms); }
  static const ArmModel& model() { return crs_f3(); }
  std::vector<WirePair*> all_lines() { return {&motion, &state}; }

  const SimpleKind kind;
  VirtualExecutor executor;
  MovingArm body{executor, crs_f3()};
  ArmCabinet cabinet{executor, body, crs_f3()};
  SimpleEmulator emulator{cabinet, kind};
  WirePair motion{executor};
  WirePair state{executor};
  Job moving{executor.spawn(serve_motion(executor, emulator, motion.far))};
  Job telling{executor.spawn(serve_state(executor, emulator, state.far))};
  SimpleWires wires{motion.near, state.near, kind.serial, kind.order, kind.sign, kind.track};
  SimpleArm arm{executor, wires, crs_f3()};
  void begin_anew() { replace(arm, executor, wires, crs_f3()); }
};

template <bool serial>
struct DrivenSimple : SimpleCell {
  static constexpr const char* name = serial ? "C500c" : "SimpleMessage";
  DrivenSimple() : SimpleCell({.serial = serial}) {}
};

using DrivenCells = testing::Types<DrivenHses, DrivenHost<EthernetCell>, DrivenHost<BscCell>, DrivenUniversal,
                                   DrivenSimple<false>, DrivenSimple<true>>;

struct DrivenCellNames {
  template <class Cell>
  static std::string GetName(int) {
    return Cell::name;
  }
};

}  // namespace pizarra
