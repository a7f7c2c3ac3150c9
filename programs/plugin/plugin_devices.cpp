#include "programs/plugin/plugin_devices.hpp"

#include <cmath>

#include "drivers/arm/arm_model.hpp"

namespace pizarra::programs {

namespace {

using simulation::Message;

Datum yes_or_no(bool value) { return value ? "yes"_sym : "no"_sym; }

std::unexpected<Failure> odd_request(const Datum& request) {
  return fail("bad-request", "a plug-in is not asked this", request);
}

plugin::Joints joints_of(const Datum& datum) {
  plugin::Joints joints;
  for (const Datum& angle : datum.items()) joints.push_back(angle.number());
  return joints;
}

class ArmDevice : public PluginDevice {
 public:
  explicit ArmDevice(std::unique_ptr<plugin::Arm> arm) : arm_(std::move(arm)) {}

 private:
  Result<Message> answer(const Datum& request) override {
    if (!request.is_form("arm") || request.size() < 2) return odd_request(request);
    const Datum& what = request[1];
    if (what.is_symbol("identify")) return Message{list(arm_->type())};
    if (what.is_symbol("read")) return state();
    if (what.is_symbol("take-control")) {
      arm_->take_control();
    } else if (what.is_symbol("release-control")) {
      arm_->release_control();
    } else if (what.is_symbol("stop")) {
      arm_->stop();
    } else if (what.is_symbol("gripper") && request.size() == 3) {
      arm_->start_gripper(request[2].number());
    } else if (what.is_symbol("move") && request.size() > 3) {
      std::vector<plugin::Joints> waypoints;
      for (const Datum& waypoint : request.items().subspan(3)) waypoints.push_back(joints_of(waypoint));
      arm_->start_move(waypoints, request[2].number());
    } else {
      return odd_request(request);
    }
    return Message{};
  }

  Result<Message> state() {
    const plugin::ArmState state = arm_->read();
    std::vector<Datum> joints;
    for (const double angle : state.joints) {
      if (!std::isfinite(angle)) return fail("disconnected", "the plug-in's arm told an angle that is no number");
      joints.push_back(Datum::real(angle));
    }
    if (joints.empty() || joints.size() > arm::most_axes || !std::isfinite(state.opening_mm)) {
      return fail("disconnected", "the plug-in's arm told no state");
    }
    return Message{list(Datum::list(std::move(joints)), yes_or_no(state.moving), yes_or_no(state.stopped),
                        state.opening_mm, yes_or_no(state.gripper_moving))};
  }

  std::unique_ptr<plugin::Arm> arm_;
};

class CameraDevice : public PluginDevice {
 public:
  CameraDevice(std::unique_ptr<plugin::Camera> camera, Executor& executor)
      : camera_(std::move(camera)), executor_(executor) {}

 private:
  Result<Message> answer(const Datum& request) override {
    if (!request.is_form("camera") || request.size() < 2) return odd_request(request);
    if (request[1].is_symbol("open")) return open();
    if (!request[1].is_symbol("next") || request.size() != 4) return odd_request(request);
    // A process that began anew has opened nothing yet.
    if (!model_) return fail("disconnected", "the plug-in's camera is not open");
    plugin::CameraPair pair = camera_->next(request[3].is_symbol("colour"));
    const int channels = request[3].is_symbol("colour") ? 3 : 1;
    Message message{list(pair.number, executor_.now().time_since_epoch().count())};
    for (plugin::Pixels* pixels : {&pair.left, &pair.right}) {
      Image image;
      image.width = model_->width;
      image.height = model_->height;
      image.channels = channels;
      const std::size_t size = static_cast<std::size_t>(model_->width) * static_cast<std::size_t>(model_->height) *
                               static_cast<std::size_t>(channels);
      if (pixels->size() != size) return fail("corrupt-frame", "the plug-in's image is not as large as it said");
      image.pixels = std::move(*pixels);
      message.images.push_back(std::make_shared<const Image>(std::move(image)));
    }
    return message;
  }

  Result<Message> open() {
    model_.reset();
    const plugin::CameraModel model = camera_->open();
    const auto fits = [](int pixels) { return pixels >= 64 && pixels <= 8192; };
    const bool numbers = std::isfinite(model.focal_px) && std::isfinite(model.centre_x_px) &&
                         std::isfinite(model.centre_y_px) && std::isfinite(model.base_line_mm);
    if (!fits(model.width) || !fits(model.height) || !numbers || model.focal_px <= 0 || model.base_line_mm < 0) {
      return fail("disconnected", "the plug-in's camera told a size or a geometry that no camera has");
    }
    model_ = model;
    return Message{
        list(model.width, model.height, model.focal_px, model.centre_x_px, model.centre_y_px, model.base_line_mm)};
  }

  std::unique_ptr<plugin::Camera> camera_;
  Executor& executor_;
  std::optional<plugin::CameraModel> model_;  // none: not open
};

}  // namespace

Result<Message> PluginDevice::handle(const Datum& request) {
  try {
    return answer(request);
  } catch (const plugin::Refused& refused) {
    if (!is_symbol_name(refused.symbol())) return fail("refused", refused.what());
    return fail(refused.symbol(), refused.what());
  } catch (const std::exception& error) {
    return fail("disconnected", error.what());
  }
}

std::unique_ptr<PluginDevice> device_of(std::unique_ptr<plugin::Arm> arm) {
  return std::make_unique<ArmDevice>(std::move(arm));
}

std::unique_ptr<PluginDevice> device_of(std::unique_ptr<plugin::Camera> camera, Executor& executor) {
  return std::make_unique<CameraDevice>(std::move(camera), executor);
}

}  // namespace pizarra::programs
