/* SPDX-License-Identifier: MIT
 *
 * Lists in OpenGL's buffers: CUDA reads the points of a 4 x 4 x 4 grid from a vertex buffer, and writes the pairs to an
 * index buffer, from which OpenGL draws each as a line between its points. Neither is copied to the host. Prints the
 * number of pairs, 144, and of pixels that the lines cover. Exits with 77 where CUDA and OpenGL share no device. */
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cuda_gl_interop.h>
#include <cuda_runtime_api.h>
#include <inttypes.h>
#include <spherepair/spherepair.h>
#include <stdio.h>
#include <stdlib.h>

#define SIDE 4
#define POINTS (SIDE * SIDE * SIDE)
#define ROOM 1000 /* pairs */
#define PIXELS 64 /* along each side of the image */

/* Makes an OpenGL context without a window current, on the GPU of CUDA's device 0. Returns what is missing, or NULL. */
static const char* open_gl(void) {
  EGLDeviceEXT devices[16];
  EGLint count = 0;
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base") || !eglQueryDevicesEXT(16, devices, &count))
    return "EGL lists no devices";
  for (EGLint k = 0; k < count; ++k) {
    EGLAttrib number = -1;
    if (!eglQueryDeviceAttribEXT(devices[k], EGL_CUDA_DEVICE_NV, &number) || number != 0) continue;
    EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[k], NULL);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) return "EGL cannot open CUDA's device 0";
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
    eglBindAPI(EGL_OPENGL_API);
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) return "there is no OpenGL 4.5";
    return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) ? NULL : "OpenGL needs a window";
  }
  return "EGL does not know CUDA's device 0";
}

static GLuint make_buffer(GLsizeiptr bytes, const void* data) {
  GLuint buffer = 0;
  glCreateBuffers(1, &buffer);
  glNamedBufferStorage(buffer, bytes, data, 0);
  return buffer;
}

static GLuint grid_of_points(void) {
  float points[POINTS][3];
  for (int n = 0; n < POINTS; ++n) {
    points[n][0] = (float)(n / (SIDE * SIDE));
    points[n][1] = (float)(n / SIDE % SIDE);
    points[n][2] = (float)(n % SIDE);
  }
  return make_buffer(sizeof points, points);
}

/* Writes the pairs of the points in `vertices` to `indices`, two of 32 bits each. Returns how many there are, or -1. */
static int64_t list_pairs(sp_context* context, GLuint vertices, GLuint indices) {
  struct cudaGraphicsResource* buffers[2] = {NULL, NULL};
  void *positions = NULL, *columns = NULL;
  size_t bytes = 0;
  cudaGraphicsGLRegisterBuffer(&buffers[0], vertices, cudaGraphicsRegisterFlagsReadOnly);
  cudaGraphicsGLRegisterBuffer(&buffers[1], indices, cudaGraphicsRegisterFlagsWriteDiscard);
  cudaGraphicsMapResources(2, buffers, NULL);
  cudaGraphicsResourceGetMappedPointer(&positions, &bytes, buffers[0]);
  cudaGraphicsResourceGetMappedPointer(&columns, &bytes, buffers[1]);

  sp_problem problem = {0};
  problem.size = sizeof problem;
  problem.positions = (sp_array){positions, POINTS, 3, 3, 1, SP_F32, 2, 0}; /* 2: in CUDA's memory */
  problem.cutoff = 1.1;
  problem.half = 1;
  sp_pairs pairs = {0};
  pairs.size = sizeof pairs;
  pairs.first = (sp_array){columns, ROOM, 1, 2, 1, SP_I32, 2, 0}; /* every second index */
  pairs.second = (sp_array){(int32_t*)columns + 1, ROOM, 1, 2, 1, SP_I32, 2, 0};
  const sp_status status = sp_fill(context, &problem, &pairs);
  if (status != SP_OK) fprintf(stderr, "cannot list the pairs: %s\n", sp_message(context));

  cudaGraphicsUnmapResources(2, buffers, NULL); /* what OpenGL does next waits for the list */
  cudaGraphicsUnregisterResource(buffers[0]);
  cudaGraphicsUnregisterResource(buffers[1]);
  return status == SP_OK ? pairs.count : -1;
}

static GLuint shader(GLenum kind, const char* text) {
  const GLuint program = glCreateShaderProgramv(kind, 1, &text);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) fprintf(stderr, "cannot compile: %s\n", text);
  return program;
}

/* Draws the pairs as lines, seen along a diagonal. Returns how many pixels they cover. */
static int draw_pairs(GLuint vertices, GLuint indices, GLsizei pairs) {
  GLuint image, target, array, pipeline;
  glCreateTextures(GL_TEXTURE_2D, 1, &image);
  glTextureStorage2D(image, 1, GL_RGBA8, PIXELS, PIXELS);
  glCreateFramebuffers(1, &target);
  glNamedFramebufferTexture(target, GL_COLOR_ATTACHMENT0, image, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glViewport(0, 0, PIXELS, PIXELS);

  glCreateVertexArrays(1, &array);
  glVertexArrayVertexBuffer(array, 0, vertices, 0, 3 * sizeof(float));
  glEnableVertexArrayAttrib(array, 0);
  glVertexArrayElementBuffer(array, indices);
  glBindVertexArray(array);

  glCreateProgramPipelines(1, &pipeline);
  glUseProgramStages(pipeline, GL_VERTEX_SHADER_BIT,
                     shader(GL_VERTEX_SHADER,
                            "#version 450\n"
                            "layout(location = 0) in vec3 at;\n"
                            "out gl_PerVertex { vec4 gl_Position; };\n"
                            "void main() { gl_Position = vec4((at.xy + 0.3 * at.z) * 0.4 - 0.8, 0.0, 1.0); }"));
  glUseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT,
                     shader(GL_FRAGMENT_SHADER,
                            "#version 450\n"
                            "layout(location = 0) out vec4 color;\n"
                            "void main() { color = vec4(1.0); }"));
  glBindProgramPipeline(pipeline);
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawElements(GL_LINES, 2 * pairs, GL_UNSIGNED_INT, NULL);

  static uint32_t pixels[PIXELS * PIXELS];
  glReadPixels(0, 0, PIXELS, PIXELS, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  int covered = 0;
  for (int n = 0; n < PIXELS * PIXELS; ++n) covered += pixels[n] != 0;
  return covered;
}

int main(void) {
  sp_context* context = NULL;
  if (sp_open("cuda", "0", 0, &context) != SP_OK) {
    fprintf(stderr, "cannot open CUDA: %s\n", sp_message(NULL));
    return 77;
  }
  const char* missing = open_gl();
  if (missing) {
    fprintf(stderr, "%s\n", missing);
    return 77;
  }
  const GLuint vertices = grid_of_points(), indices = make_buffer(2 * ROOM * sizeof(int32_t), NULL);
  const int64_t pairs = list_pairs(context, vertices, indices);
  const int covered = pairs > 0 ? draw_pairs(vertices, indices, (GLsizei)pairs) : 0;
  printf("%" PRId64 " pairs, %d pixels\n", pairs, covered);
  sp_close(context);
  return pairs == 3 * SIDE * SIDE * (SIDE - 1) && covered > PIXELS && glGetError() == GL_NO_ERROR ? 0 : 1;
}
