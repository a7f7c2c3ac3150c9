#include "drivers/camera/jpeg_faults.hpp"

#include <csetjmp>
#include <cstdio>

// They need <cstdio> before them.
#include <jerror.h>
#include <jpeglib.h>

namespace pizarra {
namespace {

using Bytes = std::span<const unsigned char>;

struct Judge {
  jpeg_error_mgr manager;  // the first: libjpeg knows of this alone
  std::jmp_buf found;
};

[[noreturn]] void end_reading(j_common_ptr jpeg) { std::longjmp(reinterpret_cast<Judge*>(jpeg->err)->found, 1); }

// Beyond libjpeg's own codes.
constexpr int too_many_scans = JMSG_LASTMSGCODE;

// Called between rows of blocks.
void count_scans(j_common_ptr jpeg) {
  if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number <= most_scans) return;
  jpeg->err->msg_code = too_many_scans;
  end_reading(jpeg);
}

// Warnings are below 0, traces above.
void take_message(j_common_ptr jpeg, int level) {
  if (level < 0) end_reading(jpeg);
}

// The first error or warning while `work` is done; 0: there was none. It is left by a jump, so nothing in `work` may
// have a destructor.
int first_fault(Bytes bytes, auto work) {
  Judge judge;
  jpeg_decompress_struct jpeg{};
  jpeg.err = jpeg_std_error(&judge.manager);
  judge.manager.error_exit = end_reading;
  judge.manager.emit_message = take_message;
  if (setjmp(judge.found) != 0) {
    jpeg_destroy_decompress(&jpeg);
    return judge.manager.msg_code;
  }
  jpeg_create_decompress(&jpeg);
  jpeg_progress_mgr progress{};
  progress.progress_monitor = count_scans;
  jpeg.progress = &progress;
  jpeg_mem_src(&jpeg, bytes.data(), bytes.size());
  jpeg_read_header(&jpeg, TRUE);
  work(jpeg);
  jpeg_destroy_decompress(&jpeg);
  return 0;
}

// At an eighth of its size, for which as much is read.
void decode(jpeg_decompress_struct& jpeg) {
  jpeg.scale_num = 1;
  jpeg.scale_denom = 8;
  jpeg_start_decompress(&jpeg);
  const JSAMPARRAY row = jpeg.mem->alloc_sarray(reinterpret_cast<j_common_ptr>(&jpeg), JPOOL_IMAGE,
                                                jpeg.output_width * static_cast<JDIMENSION>(jpeg.output_components), 1);
  while (jpeg.output_scanline < jpeg.output_height) jpeg_read_scanlines(&jpeg, row, 1);
  jpeg_finish_decompress(&jpeg);
}

}  // namespace

JpegFault fault_of_jpeg(Bytes bytes) {
  const int fault = first_fault(bytes, decode);
  if (fault == 0) return JpegFault::none;
  if (fault == too_many_scans) return JpegFault::too_many_scans;
  return fault == JWRN_JPEG_EOF ? JpegFault::cut_short : JpegFault::damaged;
}

std::optional<ImageSize> size_of_jpeg(Bytes bytes) {
  ImageSize out;
  const int fault = first_fault(bytes, [&out](const jpeg_decompress_struct& jpeg) {
    out = {jpeg.image_width, jpeg.image_height};
  });
  return fault == 0 ? std::optional(out) : std::nullopt;
}

}  // namespace pizarra
