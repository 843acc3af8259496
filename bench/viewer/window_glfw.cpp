// SPDX-License-Identifier: MIT
#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include "bench/viewer/window.h"
#include "common/backend/backend.h"

namespace spherepair {
namespace {

[[noreturn]] void fail(const char* what) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  throw BackendError(fmt::format("{}: {}; without a display, `spherepair render` draws to files", what,
                                 reason ? reason : "no reason given"));
}

class GlfwWindow final : public Window, private WindowContext {
 public:
  GlfwWindow(const std::string& title, uint width, uint height, bool shared) : shared_(shared) {
    if (!glfwInit()) fail("no window can be opened");
    // EGL, if the backends have EGL contexts of their own: GLX would conflict with them.
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, shared ? GLFW_NATIVE_CONTEXT_API : GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, shared ? 4 : 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, shared ? 5 : 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    window_ = glfwCreateWindow(int(width), int(height), title.c_str(), nullptr, nullptr);
    if (!window_) {
      try {
        fail(shared ? "no window with OpenGL 4.5 can be opened" : "no window with OpenGL 3.3 can be opened");
      } catch (...) {
        glfwTerminate();
        throw;
      }
    }
    make_current();
    glfwSwapInterval(0);
    const GLFWvidmode* mode = glfwGetPrimaryMonitor() ? glfwGetVideoMode(glfwGetPrimaryMonitor()) : nullptr;
    if (mode && mode->refreshRate > 0) refresh_seconds_ = 1.0 / mode->refreshRate;
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::StyleColorsLight();
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, note_key);  // ImGui's callback then calls ours
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 330");
  }

  ~GlfwWindow() override {
    make_current();
    glDeleteTextures(1, &texture_);
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
  }

  bool next(Present present) override {
    make_current();
    keys_.clear();
    while (drawn_ && present == Present::and_wait && glfwGetTime() < next_refresh_)
      glfwWaitEventsTimeout(std::max(next_refresh_ - glfwGetTime(), 1e-4));
    if (drawn_ && present != Present::never && glfwGetTime() >= next_refresh_) {
      glfwSwapBuffers(window_);
      next_refresh_ = glfwGetTime() + refresh_seconds_;
    }
    glfwPollEvents();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    return !glfwWindowShouldClose(window_);
  }
  double seconds() const override { return glfwGetTime(); }

  std::array<uint, 2> size() const override {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {uint(std::max(width, 1)), uint(std::max(height, 1))};
  }
  std::array<double, 2> dragged() const override {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse || io.KeyShift || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) return {};
    return {io.MouseDelta.x, io.MouseDelta.y};
  }
  std::array<double, 2> panned() const override {
    const ImGuiIO& io = ImGui::GetIO();
    const bool pans = ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                      (io.KeyShift && ImGui::IsMouseDown(ImGuiMouseButton_Left));
    if (io.WantCaptureMouse || !pans) return {};
    return {io.MouseDelta.x * io.DisplayFramebufferScale.x, io.MouseDelta.y * io.DisplayFramebufferScale.y};
  }
  double scrolled() const override { return ImGui::GetIO().WantCaptureMouse ? 0 : ImGui::GetIO().MouseWheel; }
  bool pressed(char key) const override { return keys_.find(key) != std::string::npos; }

  void begin_panel(const std::string& title) override {
    const ImVec2 whole = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({8, 8}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints({0, 0}, {whole.x - 16, whole.y - 16});
    ImGui::Begin((title + "###panel").c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PushTextWrapPos(345);
  }
  void end_panel() override {
    ImGui::PopTextWrapPos();
    ImGui::End();
  }
  void text(const std::string& line) override { ImGui::TextUnformatted(line.c_str()); }
  void legend(std::span<const uint> colours, const std::vector<std::string>& labels) override {
    for (size_t k = 0; k < labels.size(); ++k) {
      const float part = 1 / 255.0f;
      const ImVec4 colour(part * (colours[k] >> 16), part * (colours[k] >> 8 & 255), part * (colours[k] & 255), 1);
      if (k % 4) ImGui::SameLine(float(k % 4) * 90 + 8);
      ImGui::ColorButton(labels[k].c_str(), colour, ImGuiColorEditFlags_NoBorder, {14, 14});
      ImGui::SameLine();
      text(labels[k]);
    }
  }

  uint texture(uint width, uint height) override {
    if (texture_ && width == width_ && height == height_) return texture_;
    make_current();
    glDeleteTextures(1, &texture_);
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, GLsizei(width), GLsizei(height), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    width_ = width;
    height_ = height;
    return texture_;
  }

  void upload(std::span<const uint> image) override {
    make_current();
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, GLsizei(width_), GLsizei(height_), GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  }

  void show() override {
    make_current();
    const auto image = reinterpret_cast<ImTextureID>(uintptr_t(texture_));
    ImGui::GetBackgroundDrawList()->AddImage(image, {0, 0}, ImGui::GetIO().DisplaySize);
    ImGui::Render();
    const auto [window_width, window_height] = size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);  // drawing through OpenGL uses another framebuffer
    glViewport(0, 0, GLsizei(window_width), GLsizei(window_height));
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    drawn_ = true;  // next() swaps buffers; until then the back buffer has the frame for screenshot()
  }

  std::vector<uint> screenshot() override {
    const auto [width, height] = size();
    std::vector<uint> pixels(size_t(width) * height), turned(pixels.size());
    make_current();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, GLsizei(width), GLsizei(height), GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (size_t k = 0; k < pixels.size(); ++k)
      turned[k] = pixels[(height - 1 - k / width) * width + k % width] | 0xFF000000u;
    return turned;
  }

  WindowContext& context() override { return *this; }
  std::string renderer() const override { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

 private:
  void make_current() override {
    // GLFW does not notice when an EGL context replaced its own as the current one.
    if (!shared_ || glfwGetCurrentContext() != window_) glfwMakeContextCurrent(window_);
  }

  // Notes the key by its printed letter, in any layout.
  static void note_key(GLFWwindow* window, int key, int scancode, int action, int) {
    if (action != GLFW_PRESS || ImGui::GetIO().WantTextInput) return;
    const char* printed = glfwGetKeyName(key, scancode);
    std::string& keys = static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window))->keys_;
    if (key == GLFW_KEY_SPACE) keys += ' ';
    if (key == GLFW_KEY_ESCAPE) keys += escape_key;
    if (key != GLFW_KEY_SPACE && printed) keys += *printed == '=' ? '+' : *printed;
  }

  GLFWwindow* window_ = nullptr;
  std::string keys_;  // pressed since the last frame
  bool shared_;
  GLuint texture_ = 0;
  uint width_ = 0, height_ = 0;  // of the texture
  bool drawn_ = false;
  double refresh_seconds_ = 1.0 / 60, next_refresh_ = 0;
};

}  // namespace

std::unique_ptr<Window> open_window(const std::string& title, uint width, uint height, bool shared) {
  return std::make_unique<GlfwWindow>(title, width, height, shared);
}

}  // namespace spherepair
