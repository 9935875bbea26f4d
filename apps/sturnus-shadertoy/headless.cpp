// EGL calls, each with a sentence for the case that it fails.
#include "headless.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdlib>

namespace shadertoy {
namespace {

sturnus::Problem missing(const std::string& what) {
  return {"", 0, "",
          "shaders can't run here: " + what +
              "; the packages libegl1, libegl-mesa0, libgl1-mesa-dri and libgles2 have what is needed",
          false};
}

// libepoxy ends the program where a library is not there, so this comes first.
bool has_library(const char* name) {
  void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) return false;
  dlclose(library);
  return true;
}

// The same pictures and states on every machine, so by software unless the surroundings say otherwise; and
// what Mesa has to say comes as our sentence.
void choose_driver() {
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
  setenv("EGL_LOG_LEVEL", "fatal", 0);
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);  // it writes in the home folder and saves no time here
}

}  // namespace

sturnus::Status Headless::start() {
  for (const char* name : {"libEGL.so.1", "libGLESv2.so.2"}) {
    if (!has_library(name)) return missing(std::string("there is no ") + name);
  }
  choose_driver();
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
    return missing("there is no EGL driver that works without a display");
  display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) != EGL_TRUE)
    return missing("no EGL driver can be started");

  const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display_, wanted, &config, 1, &count) != EGL_TRUE || count == 0)
    return missing("the EGL driver has no OpenGL ES 3.0");
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  eglBindAPI(EGL_OPENGL_ES_API);
  context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
  if (context_ == EGL_NO_CONTEXT ||
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE)
    return missing("the EGL driver has no OpenGL ES 3.0 without a surface");
  if (!epoxy_has_gl_extension("GL_EXT_color_buffer_float"))
    return missing("the driver " + renderer() + " can't draw floats (EXT_color_buffer_float)");
  return {};
}

sturnus::Result<std::unique_ptr<Headless>> Headless::open() {
  std::unique_ptr<Headless> headless(new Headless);
  if (const sturnus::Status status = headless->start(); !status) return status.problems();
  return headless;
}

Headless::~Headless() {
  if (display_ == nullptr) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != nullptr) eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

std::string Headless::renderer() const {
  const GLubyte* name = glGetString(GL_RENDERER);
  return name != nullptr ? reinterpret_cast<const char*>(name) : "a renderer without a name";
}

}  // namespace shadertoy
