#include "drivers/simulation/controllers/arms/hses_files.hpp"

#include "drivers/arm/motoman/hses_packet.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::uint8_t file_control = 2;
constexpr std::uint8_t request_kind = 0;
constexpr std::uint8_t answer_kind = 1;
constexpr std::uint32_t last_block_bit = 0x8000'0000;
constexpr std::uint8_t deletes = 0x09;
constexpr std::uint8_t takes = 0x15;
constexpr std::uint8_t gives = 0x16;
constexpr std::uint8_t lists = 0x32;
constexpr std::size_t block_size = 400;
constexpr std::size_t longest_name = 36;  // of a job, with what its file is called after it

constexpr std::uint16_t no_such_file = 0xe2b3;

std::string file_reply(std::uint8_t id, std::uint8_t service, std::uint32_t block, std::uint16_t refusal,
                       std::string_view data = {}) {
  constexpr std::uint8_t not_done = 0x1f;
  line::OctetWriter octets(line::ByteOrder::little);
  octets.text("YERC").u16(32).u16(static_cast<std::uint16_t>(data.size())).u8(3).u8(file_control).u8(answer_kind);
  octets.u8(id).u32(block).text("99999999").u8(service | arm::hses::answered).u8(refusal == 0 ? 0 : not_done);
  return octets.u8(refusal == 0 ? 0 : 1).u8(0).u16(refusal).u16(0).text(data).octets();
}

bool is_sound_name(std::string_view name) {
  return !name.empty() && name.size() <= longest_name && name.find_first_of("/\\*?\r\n") == name.npos;
}

}  // namespace

const std::string* HsesFiles::find(std::string_view name) const {
  const auto found = files_.find(name);
  return found == files_.end() ? nullptr : &found->second;
}

std::string HsesFiles::answer(std::string_view datagram) {
  line::OctetReader read(datagram, line::ByteOrder::little);
  constexpr std::string_view begin{"YERC\x20\0", 6};
  if (read.text(begin.size()) != begin) return {};
  const std::size_t size = read.u16();
  read.u8();
  if (read.u8() != file_control) return {};
  Message message;
  message.kind = read.u8();
  message.id = read.u8();
  message.block = read.u32();
  read.text(8 + 5);
  message.service = read.u8();
  read.u16();
  message.data = read.rest();
  if (!read.sound() || message.data.size() != size) return {};
  return message.kind == request_kind ? carry_out(message)
         : message.service == takes   ? take_block(message)
                                      : next_block(message);
}

std::string HsesFiles::carry_out(const Message& message) {
  leaving_.clear();
  last_said_.clear();
  coming_name_.clear();
  taken_.reset();
  const auto refuse = [&](std::uint16_t code) { return file_reply(message.id, message.service, last_block_bit, code); };
  if (message.service == lists) return send(message, list(message.data));
  if (message.service == gives) {
    const std::string* text = find(message.data);
    return text ? send(message, *text) : refuse(no_such_file);
  }
  if (message.service == deletes) {
    const auto found = files_.find(message.data);
    if (found == files_.end()) return refuse(no_such_file);
    files_.erase(found);
    return refuse(0);
  }
  if (message.service != takes) return refuse(arm::hses::undefined_command);
  // A name alone, as the manual has it, or what the file holds behind it at once.
  const std::size_t end = message.data.find('\0');
  const std::string_view name = message.data.substr(0, end);
  if (!is_sound_name(name)) return refuse(arm::hses::out_of_range);
  if (files_.size() >= most_files && !find(name)) return refuse(arm::hses::wrong_size);
  if (end != message.data.npos) {
    files_[std::string(name)] = message.data.substr(end + 1);
    return refuse(0);
  }
  coming_name_ = name;
  coming_.clear();
  return file_reply(message.id, message.service, 0, 0);
}

// The first block of a text; the others go when the one before is acknowledged.
std::string HsesFiles::send(const Message& message, const std::string& text) {
  for (std::size_t at = 0; at == 0 || at < text.size(); at += block_size)
    leaving_.push_back(text.substr(at, block_size));
  left_ = 0;
  Message begins = message;
  begins.block = 0;
  return next_block(begins);
}

std::string HsesFiles::next_block(const Message& message) {
  // A client that repeats an acknowledgement has not had the answer to it.
  const std::uint32_t acknowledged = message.block & ~last_block_bit;
  if (left_ > 0 && acknowledged == left_ - 1) return last_said_;
  const bool next = !leaving_.empty() && acknowledged == left_;
  if (!next) return {};
  const std::string data = std::move(leaving_.front());
  leaving_.pop_front();
  ++left_;
  const std::uint32_t block = leaving_.empty() ? left_ | last_block_bit : left_;
  last_said_ = file_reply(message.id, message.service, block, 0, data);
  return last_said_;
}

std::string HsesFiles::take_block(const Message& message) {
  if (message.block == taken_) return file_reply(message.id, message.service, message.block, 0);
  if (coming_name_.empty()) return {};
  taken_ = message.block;
  coming_ += message.data;
  if (coming_.size() > longest_file) {
    coming_name_.clear();
    taken_.reset();
    return file_reply(message.id, message.service, message.block, arm::hses::wrong_size);
  }
  if ((message.block & last_block_bit) != 0) {
    files_[coming_name_] = std::move(coming_);
    coming_name_.clear();
  }
  return file_reply(message.id, message.service, message.block, 0);
}

// A line each; the pattern is *.KIND.
std::string HsesFiles::list(std::string_view pattern) const {
  const std::string_view kind = pattern.substr(pattern.starts_with('*') ? 1 : 0);
  std::string names;
  for (const auto& file : files_) {
    if (file.first.ends_with(kind)) names += file.first + "\r\n";
  }
  return names;
}

}  // namespace pizarra::simulation
