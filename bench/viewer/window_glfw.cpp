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
  std::optional<std::array<uint, 2>> clicked() const override {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse || !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return {};
    const ImVec2 at = io.MousePos, from = io.MouseClickedPos[ImGuiMouseButton_Left];
    const bool dragged = std::abs(at.x - from.x) + std::abs(at.y - from.y) > 3;
    if (dragged || at.x < 0 || at.y < 0 || at.x >= io.DisplaySize.x || at.y >= io.DisplaySize.y) return {};
    return std::array{uint(at.x * io.DisplayFramebufferScale.x), uint(at.y * io.DisplayFramebufferScale.y)};
  }
  bool pressed(char key) const override { return keys_.find(key) != std::string::npos; }

  void begin_panel(const std::string& title, bool& folded) override {
    const ImVec2 whole = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({8, 8}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints({0, 0}, {whole.x - 16, whole.y - 16});
    ImGui::SetNextWindowCollapsed(folded);
    ImGui::Begin((title + "###panel").c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    folded = ImGui::IsWindowCollapsed();
    ImGui::PushTextWrapPos(345);
  }
  void end_panel() override {
    ImGui::PopTextWrapPos();
    ImGui::End();
  }
  void text(const std::string& line) override { ImGui::TextUnformatted(line.c_str()); }
  void same_row() override { ImGui::SameLine(); }
  bool button(const char* label) override { return ImGui::Button(label); }
  void check(const char* label, bool& value) override { ImGui::Checkbox(label, &value); }
  void slide(const char* label, uint64_t& value, uint64_t low, uint64_t high) override {
    ImGui::SetNextItemWidth(170);
    ImGui::SliderScalar(label, ImGuiDataType_U64, &value, &low, &high);
  }
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
  void choose(const char* label, const std::vector<std::string>& names, size_t& chosen) override {
    ImGui::SetNextItemWidth(170);
    if (!ImGui::BeginCombo(label, names[chosen].c_str())) return;
    for (size_t k = 0; k < names.size(); ++k)
      if (ImGui::Selectable(names[k].c_str(), k == chosen)) chosen = k;
    ImGui::EndCombo();
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

  void line(Point a, Point b, double thickness, uint colour, double opacity) override {
    lines_.push_back({a, b, thickness, colour, opacity});
  }

  void show() override {
    make_current();
    const auto whole = ImGui::GetIO().DisplaySize, scale = ImGui::GetIO().DisplayFramebufferScale;
    ImDrawList& under = *ImGui::GetBackgroundDrawList();
    under.AddImage(reinterpret_cast<ImTextureID>(uintptr_t(texture_)), {0, 0}, whole);
    const auto on_screen = [&](Point at) { return ImVec2(float(at.x + 0.5) / scale.x, float(at.y + 0.5) / scale.y); };
    for (const Line& each : lines_) {
      const ImU32 ink = IM_COL32(each.colour >> 16, each.colour >> 8 & 255, each.colour & 255, 255 * each.opacity);
      under.AddLine(on_screen(each.a), on_screen(each.b), ink, float(each.thickness) / scale.x);
    }
    lines_.clear();
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

  struct Line {
    Point a, b;
    double thickness;
    uint colour;
    double opacity;
  };

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
  std::vector<Line> lines_;
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
