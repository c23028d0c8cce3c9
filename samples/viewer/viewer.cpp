// SPDX-License-Identifier: MIT
// Events -> camera and look -> frames. While something changes, each picture is a single filtered
// frame; otherwise frames accumulate into the finished picture.
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

/// A scene with its renderer, which refers to the scene.
struct LoadedScene {
  Scene scene;
  std::unique_ptr<SceneRenderer> renderer;
};

class Viewer {
public:
  /// `stamp`: the file stamp of the scene from before it was read.
  Viewer(const ViewCommand& command, Scene scene, std::optional<FileStamp> stamp,
         RenderSettings settings, VulkanDevice& device, Window& window)
      : command_(command), settings_(std::move(settings)), device_(device), pipelines_(device),
        window_(window), watch_(stamp), swapchain_(device, window.createSurface(device.instance())),
        display_(device), current_(prepare(std::move(scene))),
        camera_(current_->renderer->camera(), current_->renderer->subject()),
        controls_(startingLook()) {
    look_ = controls_.look();
    settings_.camera = "auto"; // the camera may be missing after a reload
    writeAllNotes();
  }

  void run() {
    followSize();
    while (!window_.shouldClose()) {
      const bool isIdle = finished() && !isStale_ && !needsResize_;
      const std::chrono::duration<double> timeout = FileWatch::kInterval;
      for (const WindowEvent& event : window_.events(isIdle || !hasArea_ ? timeout.count() : 0.0))
        handle(event);
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

  std::unique_ptr<LoadedScene> prepare(Scene scene) {
    settings_.pipelines = &pipelines_;
    auto loaded = std::make_unique<LoadedScene>();
    loaded->scene = std::move(scene);
    loaded->renderer = std::make_unique<SceneRenderer>(device_, loaded->scene, settings_);
    return loaded;
  }

  /// Writes all notes about the current scene.
  void writeAllNotes() {
    writtenNotes_.clear();
    writeNewNotes(current_->scene.notes);
    writeNewNotes(current_->renderer->notes());
  }

  /// Writes the notes about the current scene that are not written yet.
  void writeNewNotes(std::vector<std::string> notes) {
    std::erase_if(notes,
                  [&](const std::string& note) { return !writtenNotes_.insert(note).second; });
    writeNotes(notes);
  }

  void handle(const WindowEvent& event) {
    std::visit(Overloaded{[&](const Key& key) { handleRequest(controls_.press(key), key.shift); },
                          [&](const Orbited& orbited) {
                            camera_.turn(orbited.drag);
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

  void handleRequest(Request request, bool shift) {
    switch (request) {
    case Request::fit:
      fit(shift ? "auto" : command_.camera);
      break;
    case Request::screenshot:
      screenshotRequested_ = true;
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
    const Sphere& subject = current_->renderer->subject();
    const float aspect = float(settings_.width) / float(settings_.height);
    Result<Camera> camera = chooseCamera(current_->scene, subject, choice, aspect);
    if (!camera) // the reloaded scene no longer has this camera
      camera = chooseCamera(current_->scene, subject, "auto", aspect);
    camera_ = OrbitCamera(renderer::take(std::move(camera)), subject);
    moved_ = true;
  }

  /// Reloads a changed scene; on failure, the last good scene stays visible.
  void reloadIfChanged() {
    const auto now = FileWatch::Clock::now();
    if (!watch_.isDue(now))
      return;
    const FileWatch::Change change = watch_.look(stampOf(command_.scene), now);
    if (change == FileWatch::Change::gone)
      reportLastSceneStays(command_.scene + ": is gone");
    if (change != FileWatch::Change::written)
      return;
    try {
      settings_.exposureEv = look_.exposureEv;
      show(prepare(renderer::take(readScene(command_.scene))));
    } catch (const Failure& failure) {
      reportLastSceneStays(failure.error.message);
    } catch (const std::bad_alloc&) {
      reportLastSceneStays(command_.scene + ": not enough memory to render the scene");
    }
  }

  /// Replaces the shown scene, keeping camera and look. Restores it on failure.
  void show(std::unique_ptr<LoadedScene> next) {
    next->renderer->setCamera(camera_.camera());
    std::swap(current_, next);
    const Look last = look_;
    try {
      look_ = startingLook(); // the state of a new renderer
      followLook();
    } catch (...) {
      std::swap(current_, next);
      look_ = last;
      throw;
    }
    writeAllNotes();
    restart();
  }

  static void reportLastSceneStays(const std::string& reason) {
    std::fprintf(stderr, "lichen-view: %s; the last good scene stays visible\n",
                 oneLine(reason).c_str());
  }

  void followLook() {
    SceneRenderer& renderer = *current_->renderer;
    const Look& target = controls_.look();
    if (look_ != target) {
      renderer.setExposure(target.exposureEv);
      renderer.setDebugView(target.debugView);
      if (look_.noise != target.noise) {
        renderer.setNoise(target.noise);
        writeNewNotes(renderer.notes());
      }
      look_ = target;
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
    if (!changed && !needsResize_)
      return;
    windowSize_ = size;
    const bool isOpen = size.width > 0 && size.height > 0;
    hasArea_ = isOpen && swapchain_.resize(size);
    needsResize_ = isOpen && !hasArea_;
    if (!hasArea_)
      return;
    const VkExtent2D extent = swapchain_.extent();
    isStale_ = true;
    if (extent.width == settings_.width && extent.height == settings_.height)
      return;
    settings_.width = extent.width;
    settings_.height = extent.height;
    current_->renderer->setSize(extent.width, extent.height); // no frame is in flight
    restart();
  }

  void restart() {
    frames_ = 0;
    isPreview_ = true;
  }

  [[nodiscard]] bool finished() const { return !isPreview_ && frames_ == settings_.frames; }

  void draw() {
    if (!finished() || isStale_)
      drawFrame();
    if (finished() && std::exchange(screenshotRequested_, false))
      writeScreenshot();
  }

  void drawFrame() {
    std::uint32_t shownFrames = 0;
    bool isAcquired = false;
    renderer::take(device_.submit([&](VkCommandBuffer commands) {
      shownFrames = recordScene(commands);
      isAcquired = isStale_ && swapchain_.acquire();
      if (isAcquired)
        swapchain_.recordCopy(commands,
                              display_.record(commands, current_->renderer->sum(), shownFrames));
    }));
    if (!isStale_)
      return;
    isStale_ = !isAcquired;
    needsResize_ = !isAcquired || !swapchain_.present();
    if (isAcquired)
      showTitle(shownFrames);
  }

  /// Records the next frame of the scene, if one is left. Returns the number of frames in the sum.
  std::uint32_t recordScene(VkCommandBuffer commands) {
    SceneRenderer& renderer = *current_->renderer;
    if (std::exchange(isPreview_, false)) {
      renderer.setPreview();
      renderer.recordFrame(commands, 0);
      isStale_ = true;
      return 1;
    }
    if (frames_ < settings_.frames) {
      renderer.setFrames(settings_.frames);
      renderer.recordFrame(commands, frames_++);
      // With fewer frames, each with sharper textures, the sum looks noisier than the preview.
      isStale_ = isStale_ || frames_ >= std::min(settings_.frames, kMostSharpeningFrames);
    }
    return frames_;
  }

  void writeScreenshot() {
    Result<std::filesystem::path> path = screenshotPath(command_.output, command_.scene);
    Result<void> written =
        path ? writePicture(path.value(), current_->renderer->average(settings_.frames))
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
  RenderSettings settings_; ///< with the current size and exposure
  VulkanDevice& device_;
  PipelineStore pipelines_; ///< of all scenes and views that have been shown
  Window& window_;
  FileWatch watch_;
  Swapchain swapchain_;
  DisplayPass display_;
  std::set<std::string> writtenNotes_; ///< about the current scene
  std::unique_ptr<LoadedScene> current_;
  OrbitCamera camera_;
  Controls controls_;
  Look look_; ///< the look that the renderer shows
  VkExtent2D windowSize_{};
  std::uint32_t frames_ = 0; ///< frames in the sum
  bool isPreview_ = true;    ///< the next frame is a preview
  bool isStale_ = false;     ///< the window does not show the latest picture
  bool needsResize_ = false; ///< the swapchain must be re-created
  bool hasArea_ = false;
  bool moved_ = false;
  bool screenshotRequested_ = false;
};

} // namespace

Result<void> view(const ViewCommand& command) {
  const std::optional<FileStamp> stamp = stampOf(command.scene);
  Result<Scene> scene = readScene(command.scene);
  if (!scene)
    return scene.error();
  std::vector<std::string> notes;
  RenderSettings settings = take(settingsOf(command, notes));
  writeNotes(notes);
  SkyCache skies;
  settings.skies = &skies;

  Window window(settings.width, settings.height, oneLine(scene.value().name));
  VulkanDeviceOptions options = deviceOptionsOf(command);
  options.instanceExtensions = Window::instanceExtensions();
  options.deviceExtensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
  options.canPresent = Window::canPresent;
  std::unique_ptr<VulkanDevice> device = take(VulkanDevice::create(options));
  Viewer(command, std::move(scene).value(), stamp, std::move(settings), *device, window).run();
  const std::shared_ptr<const ValidationMessages> messages = device->keptMessages();
  device.reset(); // so that the layers report leaked objects
  return checkMessages(*messages);
}

} // namespace lichen::renderer
