// Python's clients, plain and of asyncio, and an image stream.

#include <gtest/gtest.h>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/streams/remote_streams.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/blackboard/child_program.hpp"
#include "tests/blackboard/streams/frames.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::streams {
namespace {

constexpr const char* script = R"(
import asyncio
import sys
sys.path.insert(0, sys.argv[1])
from pizarra import AsyncBoard, Board, Failure
try:
    import numpy
except ImportError:
    numpy = None

def say(first, second):
    print(first.width, first.height, first.channels, len(first.pixels), second.number > first.number)
    if numpy:
        image = first.array()
        print(image.shape, image.dtype, image.tobytes() == first.pixels)

with Board(sys.argv[2], "script") as board:
    eyes = board.stream("eyes")
    say(eyes.next(timeout=20), eyes.next(timeout=20))
    near = board.stream("near")
    say(near.next(timeout=20), near.next(timeout=20))
    try:
        board.stream("elsewhere").next(timeout=20)
    except Failure as failure:
        print(failure.symbol)

async def two_of(board, name):
    frames = []
    async with board.stream(name) as stream:
        async for frame in stream:
            frames.append(frame)
            if len(frames) == 2:
                return frames

async def look():
    async with AsyncBoard(sys.argv[2], "loop") as board:
        say(*await two_of(board, "eyes"))
        say(*await two_of(board, "near"))
        try:
            await board.stream("elsewhere").next(timeout=20)
        except Failure as failure:
            print(failure.symbol)
asyncio.run(look())
print("numpy" if numpy else "no numpy")
)";

TEST(PythonStream, SeesTheNewestFramesOverTheNetworkAndOnThisMachineAndIsToldWhereThereIsNoWay) {
  RealExecutor executor;
  memory::MemoryBoard board(executor);
  const std::string address = "ipc://" + scratch_folder() + "board";
  const auto server = server::BoardServer::open(executor, board, {.addresses = {address}}).value();
  const std::unique_ptr<Board> view = board.view("publisher");
  const auto streams = RemoteStreams::open(executor, *view, "tcp://127.0.0.1:*").value();
  const auto near = RemoteStreams::open(executor, *view).value();
  ASSERT_TRUE(board.declare("publisher", {stream_relation()}).has_value());
  Transaction announcing;
  const Datum nobody = list(list("door"_sym, Datum::string("of another machine")));
  announcing.tell(stream_fact("eyes", "left", *streams)).tell(stream_fact("near", "left", *near));
  announcing.tell(list("stream"_sym, "elsewhere"_sym, "left"_sym, nobody));
  ASSERT_TRUE(board.transact("publisher", announcing).has_value());
  ChildProgram python({"/usr/bin/python3", "-c", script, source_dir() + "/blackboard/python", address});
  std::uint64_t number = 0;
  const std::function<void()> publish = [&] {
    streams->publish("eyes", numbered_frame(++number, 12, 8, 3));
    near->publish("near", numbered_frame(number, 12, 8, 3));
    executor.call_at(executor.now() + 5ms, publish);
  };
  publish();
  const Time patience = executor.now() + 30s;
  executor.run_until([&] { return python.ended() || executor.now() > patience; });
  ASSERT_TRUE(python.ended());
  const std::string said = python.rest();
  const bool numpy = said.ends_with("\nnumpy\n");
  const std::string frame = numpy ? "12 8 3 288 True\n(8, 12, 3) uint8 True\n" : "12 8 3 288 True\n";
  EXPECT_EQ(said, frame + frame + "no-image\n" + frame + frame + "no-image\n" + (numpy ? "numpy\n" : "no numpy\n"));
  EXPECT_EQ(python.wait(), 0);
}

}  // namespace
}  // namespace pizarra::streams
