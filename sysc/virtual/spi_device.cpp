// SPDX-License-Identifier: Apache-2.0
// The device /dev/spidevBUS.SELECT: <linux/spi/spidev.h>.
#include <fcntl.h>
#include <linux/spi/spidev.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <boost/system/system_error.hpp>
#include <cerrno>

#include "sysc/link/spi_link.hpp"

namespace curvecore::sysc {
namespace {

class SpiDevice : public SpiBus {
  public:
    SpiDevice(const std::string& device, unsigned hertz)
        : file_(open(device.c_str(), O_RDWR | O_CLOEXEC)) {
        check(file_);
        try {
            const std::uint8_t mode = SPI_MODE_0;
            const std::uint8_t bits = 8;
            check(ioctl(file_, SPI_IOC_WR_MODE, &mode));
            check(ioctl(file_, SPI_IOC_WR_BITS_PER_WORD, &bits));
            check(ioctl(file_, SPI_IOC_WR_MAX_SPEED_HZ, &hertz));
        } catch (...) {
            close(file_);
            throw;
        }
    }
    ~SpiDevice() override { close(file_); }
    SpiDevice(const SpiDevice&) = delete;
    SpiDevice& operator=(const SpiDevice&) = delete;

    Bytes exchange(const Bytes& bytes) override {
        Bytes came(bytes.size());
        spi_ioc_transfer transfer{};
        transfer.tx_buf = reinterpret_cast<std::uintptr_t>(bytes.data());
        transfer.rx_buf = reinterpret_cast<std::uintptr_t>(came.data());
        transfer.len = static_cast<std::uint32_t>(bytes.size());
        check(ioctl(file_, SPI_IOC_MESSAGE(1), &transfer));
        return came;
    }

  private:
    static void check(int result) {
        using boost::system::system_error;
        if (result < 0) throw system_error(errno, boost::system::generic_category());
    }

    int file_;
};

}  // namespace

std::unique_ptr<SpiBus> open_spi_device(const std::string& device, unsigned hertz) {
    return std::make_unique<SpiDevice>(device, hertz);
}

}  // namespace curvecore::sysc
