// SPDX-License-Identifier: MIT
// Events -> camera and look -> frames. While something changes each picture is one frame, filtered
// for itself; when nothing does, frames are added up to the finished picture.
#include "viewer.h"

#include "controls.h"
#include "display_pass.h"
#include "environment.h"
#include "failure.h"
#include "file_watch.h"
#include "frame_data.h"
#include "orbit_camera.h"
#include "picture.h"
#include "pipelines.h"
#include "program.h"
#include "scene_renderer.h"
#include "screenshot.h"
#include "swapchain.h"
#include "window.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <set>
#include <string>
#include <vector>

namespace lichen::renderer {
namespace {

template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

/// A scene and what draws it, which keeps a reference to it.
struct Shown {
  Scene scene;
  std::unique_ptr<SceneRenderer> renderer;
};

class Viewer {
public:
  /// `stamp`: that of the scene's file before it was read.
  Viewer(const ViewCommand& command, Scene scene, std::optional<FileStamp> stamp,
         RenderSettings settings, VulkanDevice& device, Window& window)
      : command_(command), settings_(std::move(settings)), device_(device),
        pipelines_(device.device()), window_(window), watch_(stamp),
        swapchain_(device, window.createSurface(device.instance())), display_(device),
        shown_(prepare(std::move(scene))),
        camera_(shown_->renderer->camera(), shown_->renderer->subject()),
        controls_(shown_->renderer->noiseNames(), startingLook()) {
    look_ = controls_.look();
    settings_.camera = "auto"; // a scene that is read again may have lost the one to start from
    tellAll();
  }

  void run() {
    followSize();
    while (!window_.shouldClose()) {
      const bool isIdle = finished() && !isStale_ && !isOutdated_;
      const std::chrono::duration<double> patience = FileWatch::kInterval;
      for (const WindowEvent& event : window_.events(isIdle || !hasArea_ ? patience.count() : 0.0))
        take(event);
      reloadIfChanged();
      followLook();
      followSize();
      if (hasArea_ && !window_.shouldClose())
        draw();
    }
  }

private:
  [[nodiscard]] Look startingLook() const {
    Look look;
    look.exposureEv = settings_.exposureEv;
    return look;
  }

  std::unique_ptr<Shown> prepare(Scene scene) {
    settings_.pipelines = &pipelines_;
    auto shown = std::make_unique<Shown>();
    shown->scene = std::move(scene);
    shown->renderer = std::make_unique<SceneRenderer>(device_, shown->scene, settings_);
    return shown;
  }

  /// All notes on the scene that is shown now.
  void tellAll() {
    told_.clear();
    tell(shown_->scene.notes);
    tell(shown_->renderer->notes());
  }

  /// Those notes on the scene that have not been told.
  void tell(std::vector<std::string> notes) {
    std::erase_if(notes, [&](const std::string& note) { return !told_.insert(note).second; });
    writeNotes(notes);
  }

  void take(const WindowEvent& event) {
    std::visit(Overloaded{[&](const Key& key) { answer(controls_.press(key), key.shift); },
                          [&](const Turned& turned) {
                            camera_.turn(turned.drag);
                            moved_ = true;
                          },
                          [&](const Panned& panned) {
                            camera_.pan(panned.drag);
                            moved_ = true;
                          },
                          [&](const Zoomed& zoomed) {
                            camera_.zoom(zoomed.steps);
                            moved_ = true;
                          },
                          [&](const Exposed&) { isStale_ = true; }},
               event);
  }

  void answer(Request request, bool shift) {
    switch (request) {
    case Request::fit:
      fit(shift ? "auto" : command_.camera);
      break;
    case Request::screenshot:
      screenshotAsked_ = true;
      break;
    case Request::help:
      std::fputs(std::string(Controls::help()).c_str(), stdout);
      std::fflush(stdout);
      break;
    case Request::close:
      window_.close();
      break;
    case Request::none:
      break;
    }
  }

  void fit(const std::string& choice) {
    const Sphere& subject = shown_->renderer->subject();
    const float aspect = float(settings_.width) / float(settings_.height);
    Result<Camera> camera = chooseCamera(shown_->scene, subject, choice, aspect);
    if (!camera) // a scene that was read again and has lost it
      camera = chooseCamera(shown_->scene, subject, "auto", aspect);
    camera_ = OrbitCamera(renderer::take(std::move(camera)), subject);
    moved_ = true;
  }

  /// What cannot be read or drawn leaves the last good scene where it is.
  void reloadIfChanged() {
    const auto now = FileWatch::Clock::now();
    if (!watch_.isDue(now))
      return;
    const FileWatch::Change change = watch_.look(stampOf(command_.scene), now);
    if (change == FileWatch::Change::gone)
      tellLastSceneStays(command_.scene + ": is gone");
    if (change != FileWatch::Change::written)
      return;
    try {
      settings_.exposureEv = look_.exposureEv;
      show(prepare(renderer::take(readScene(command_.scene))));
    } catch (const Failure& failure) {
      tellLastSceneStays(failure.error.message);
    } catch (const std::bad_alloc&) {
      tellLastSceneStays(command_.scene + ": not enough memory to draw it");
    }
  }

  /// From the same place and with the same look; with what was shown, where that cannot be.
  void show(std::unique_ptr<Shown> fresh) {
    fresh->renderer->setCamera(camera_.camera());
    std::swap(shown_, fresh);
    const Look last = look_;
    try {
      controls_.setNoises(shown_->renderer->noiseNames());
      look_ = startingLook(); // that of a fresh renderer
      followLook();
    } catch (...) {
      std::swap(shown_, fresh);
      controls_.setNoises(shown_->renderer->noiseNames());
      look_ = last;
      throw;
    }
    tellAll();
    restart();
  }

  static void tellLastSceneStays(const std::string& reason) {
    std::fprintf(stderr, "lichen-view: %s; the last good scene is shown\n",
                 oneLine(reason).c_str());
  }

  void followLook() {
    SceneRenderer& renderer = *shown_->renderer;
    const Look& wanted = controls_.look();
    if (look_ != wanted) {
      renderer.setExposure(wanted.exposureEv);
      renderer.setDebugView(wanted.debugView);
      if (look_.noise != wanted.noise) {
        renderer.setNoise(wanted.noise);
        tell(renderer.notes());
      }
      look_ = wanted;
      restart();
    }
    if (std::exchange(moved_, false)) {
      renderer.setCamera(camera_.camera());
      restart();
    }
  }

  void followSize() {
    const VkExtent2D size = window_.size();
    const bool changed = size.width != windowSize_.width || size.height != windowSize_.height;
    if (!changed && !isOutdated_)
      return;
    windowSize_ = size;
    const bool isOpen = size.width > 0 && size.height > 0;
    hasArea_ = isOpen && swapchain_.resize(size);
    isOutdated_ = isOpen && !hasArea_;
    if (!hasArea_)
      return;
    const VkExtent2D extent = swapchain_.extent();
    isStale_ = true;
    if (extent.width == settings_.width && extent.height == settings_.height)
      return;
    settings_.width = extent.width;
    settings_.height = extent.height;
    shown_->renderer->setSize(extent.width, extent.height);
    restart();
  }

  void restart() {
    frames_ = 0;
    isPreview_ = true;
  }

  [[nodiscard]] bool finished() const { return !isPreview_ && frames_ == settings_.frames; }

  void draw() {
    SceneRenderer& renderer = *shown_->renderer;
    std::uint32_t shownFrames = frames_;
    if (isPreview_) {
      renderer.setPreview();
      renderer.drawFrame(0);
      shownFrames = 1;
      isPreview_ = false;
      isStale_ = true;
    } else if (frames_ < settings_.frames) {
      renderer.setFrames(settings_.frames);
      renderer.drawFrame(frames_++);
      shownFrames = frames_;
      // Fewer frames, each sharper than a pixel, are rougher than the preview that is there.
      isStale_ = isStale_ || frames_ >= std::min(settings_.frames, kMostSharpeningFrames);
    }
    if (std::exchange(isStale_, false)) {
      isOutdated_ = !swapchain_.present(display_.show(renderer.sum(), shownFrames));
      showTitle(shownFrames);
    }
    if (finished() && std::exchange(screenshotAsked_, false))
      writeScreenshot();
  }

  void writeScreenshot() {
    Result<std::filesystem::path> path = screenshotPath(command_.output, command_.scene);
    Result<void> written =
        path ? writePicture(path.value(), shown_->renderer->average(settings_.frames))
             : Result<void>(path.error());
    if (written)
      std::printf("%s\n", oneLine(path.value().string()).c_str());
    else
      std::fprintf(stderr, "lichen-view: %s\n", oneLine(written.error().message).c_str());
    std::fflush(stdout);
  }

  void showTitle(std::uint32_t frames) {
    const std::string summary = controls_.summary();
    const std::string title =
        fmt::format("{}{}{} - {} of {} frames - H: help",
                    oneLine(std::filesystem::path(command_.scene).filename().string()),
                    summary.empty() ? "" : " - ", summary, frames, settings_.frames);
    window_.setTitle(title);
  }

  const ViewCommand& command_;
  RenderSettings settings_; ///< size and exposure as they are now
  VulkanDevice& device_;
  PipelineStore pipelines_; ///< of all scenes and views that have been shown
  Window& window_;
  FileWatch watch_;
  Swapchain swapchain_;
  DisplayPass display_;
  std::set<std::string> told_; ///< notes
  std::unique_ptr<Shown> shown_;
  OrbitCamera camera_;
  Controls controls_;
  Look look_; ///< that the renderer has
  VkExtent2D windowSize_{};
  std::uint32_t frames_ = 0; ///< in the sum
  bool isPreview_ = true;    ///< the next frame stands alone
  bool isStale_ = false;     ///< the window does not show what there is
  bool isOutdated_ = false;  ///< the window's images are to be made anew
  bool hasArea_ = false;
  bool moved_ = false;
  bool screenshotAsked_ = false;
};

} // namespace

Result<void> view(const ViewCommand& command) {
  const std::optional<FileStamp> stamp = stampOf(command.scene);
  Result<Scene> scene = readScene(command.scene);
  if (!scene)
    return scene.error();
  SkyCache skies;
  RenderSettings settings;
  settings.width = std::uint32_t(command.size[0]);
  settings.height = std::uint32_t(command.size[1]);
  settings.frames = std::uint32_t(command.frames);
  settings.camera = command.camera;
  settings.exposureEv = float(command.exposureEv);
  settings.skies = &skies;
  if (!command.environment.empty())
    settings.environment = take(readPanorama(command.environment));

  Window window(settings.width, settings.height, oneLine(scene.value().name));
  VulkanDeviceOptions options;
  options.choice = command.device;
  options.validation = command.validate;
  options.instanceExtensions = Window::instanceExtensions();
  options.deviceExtensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
  options.canPresent = Window::canPresent;
  std::unique_ptr<VulkanDevice> device = take(VulkanDevice::create(options));
  Viewer(command, std::move(scene).value(), stamp, std::move(settings), *device, window).run();
  const std::shared_ptr<const ValidationMessages> messages = device->keptMessages();
  device.reset(); // the layers report what was never destroyed
  return checkMessages(*messages);
}

} // namespace lichen::renderer
