#include "optim/design/drive_tables.hpp"

namespace liesl {

double duration_of(const std::vector<ConstantSpec>& constants, double duration,
                   const std::vector<double>& x) {
  for (std::size_t i = 0; i < constants.size(); ++i)
    if (constants[i].quantity == ConstantQuantity::Duration) return x[i];
  return duration;
}

std::vector<DriveTable> drive_tables(const std::vector<ConstantSpec>& constants,
                                     std::vector<DriveTable> tables, double duration,
                                     const std::vector<double>& x) {
  for (std::size_t i = 0; i < constants.size(); ++i) {
    const ConstantSpec& c = constants[i];
    if (c.quantity == ConstantQuantity::DriveValue)
      tables.at(static_cast<std::size_t>(c.drive)).q.at(static_cast<std::size_t>(c.row)) = x[i];
  }
  const double stretch = duration > 0 ? duration_of(constants, duration, x) / duration : 1;
  for (DriveTable& table : tables)
    for (double& t : table.t) t *= stretch;
  return tables;
}

}  // namespace liesl
