// SPDX-License-Identifier: Apache-2.0
// Runs a kinematics module of LinuxCNC outside of it, on its own: the pins that it asks the HAL for
// are numbers of this program.
//
//   kinematics_judge MODULE.so [PIN=VALUE ..]    pins as the module names them
//
// Reads lines `j0 j1 j2 a b c`, three joints and angles of the tool; writes the place x y z that
// the module's kinematicsForward makes of them, and the joints that its kinematicsInverse makes of
// that.
#include <dlfcn.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

namespace {

std::map<std::string, double>& values() {
    static std::map<std::string, double> of;
    return of;
}

std::map<std::string, bool>& bits() {
    static std::map<std::string, bool> of;
    return of;
}

std::string formatted(const char* format, std::va_list arguments) {
    std::array<char, 128> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    return text.data();
}

int give(double** pin, const std::string& name) {
    *pin = &values()[name];
    return 0;
}

/// The place of LinuxCNC's tool: X Y Z, A B C, U V W.
struct Pose {
    double x, y, z, a, b, c, u, v, w;
};

using Kinematics = int (*)(const double* from, double* to, unsigned long*, unsigned long*);

}  // namespace

// What a module asks of the HAL and of its runtime, by LinuxCNC's names.
extern "C" {
int hal_init(const char* /*name*/) { return 1; }
int hal_ready(int /*component*/) { return 0; }
int hal_exit(int /*component*/) { return 0; }
void* hal_malloc(long size) { return std::calloc(1, static_cast<std::size_t>(size)); }
void rtapi_print(const char* /*format*/, ...) {}
void rtapi_print_msg(int /*level*/, const char* /*format*/, ...) {}
int hal_pin_float_new(const char* name, int /*direction*/, double** pin, int /*component*/) {
    return give(pin, name);
}
int hal_pin_float_newf(int /*direction*/, double** pin, int /*component*/, const char* format,
                       ...) {
    std::va_list arguments;
    va_start(arguments, format);
    const std::string name = formatted(format, arguments);
    va_end(arguments);
    return give(pin, name);
}
int hal_pin_bit_new(const char* name, int /*direction*/, bool** pin, int /*component*/) {
    *pin = &bits()[name];
    return 0;
}
int hal_pin_s32_new(const char* /*name*/, int /*direction*/, int** pin, int /*component*/) {
    static int number = 0;
    *pin = &number;
    return 0;
}
}

int main(int count, char** arguments) {
    if (count < 2) {
        std::cerr << "kinematics_judge: MODULE.so [PIN=VALUE ..]\n";
        return 2;
    }
    void* const module = dlopen(arguments[1], RTLD_NOW);
    if (module == nullptr) {
        std::cerr << dlerror() << '\n';
        return 1;
    }
    if (void* const letters = dlsym(module, "rtapi_info_address_coordinates")) {
        static const char* const kLetters = "XYZABC";
        *static_cast<const char**>(*static_cast<void**>(letters)) = kLetters;
    }
    const auto begin = reinterpret_cast<int (*)()>(dlsym(module, "rtapi_app_main"));
    const auto forward = reinterpret_cast<Kinematics>(dlsym(module, "kinematicsForward"));
    const auto inverse = reinterpret_cast<Kinematics>(dlsym(module, "kinematicsInverse"));
    if (begin == nullptr || forward == nullptr || inverse == nullptr || begin() != 0) {
        std::cerr << arguments[1] << ": no kinematics\n";
        return 1;
    }
    // The module has set its pins to its own defaults.
    for (int i = 2; i < count; ++i) {
        const std::string asked = arguments[i];
        const std::size_t equals = asked.find('=');
        const std::string name = asked.substr(0, equals);
        const double value = std::stod(asked.substr(equals + 1));
        if (values().count(name) + bits().count(name) == 0) {
            std::cerr << arguments[1] << ": no pin " << name << '\n';
            return 1;
        }
        if (bits().count(name) > 0) {
            bits()[name] = value != 0;
        } else {
            values()[name] = value;
        }
    }
    std::array<double, 16> joints{};
    std::array<double, 3> abc{};
    std::cout.precision(17);
    while (std::cin >> joints[0] >> joints[1] >> joints[2] >> abc[0] >> abc[1] >> abc[2]) {
        for (std::size_t i = 0; i < 3; ++i) joints[3 + i] = abc[i];
        Pose pose{};
        unsigned long of_forward = 0;
        unsigned long of_inverse = 0;
        forward(joints.data(), &pose.x, &of_forward, &of_inverse);
        std::array<double, 16> again{};
        inverse(&pose.x, again.data(), &of_inverse, &of_forward);
        std::cout << pose.x << ' ' << pose.y << ' ' << pose.z << ' ' << again[0] << ' ' << again[1]
                  << ' ' << again[2] << '\n';
    }
    return 0;
}
