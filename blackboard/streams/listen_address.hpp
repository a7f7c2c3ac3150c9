#pragma once

// Where a publisher listens so that other machines reach it.
//
//   stream_listen_address("tcp://10.0.0.1:7800");       // "tcp://10.0.0.7:*" on the machine that is 10.0.0.7

#include <string>

namespace pizarra::streams {

// The address of this machine on the way to the board's, any port: "tcp://10.0.0.7:*". Of a board that listens
// everywhere, `tcp://*:7800`, the one on the way out. Empty where no other machine comes to the board: at ipc and
// loopback addresses, or without a network.
std::string stream_listen_address(const std::string& board_address);

}  // namespace pizarra::streams
