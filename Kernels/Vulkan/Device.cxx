#include "DeviceState.h"
#include "ProgramLibrary.h"

#include "../System.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <mutex>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>

namespace rtg
{

namespace
{

constexpr const char* rayExtensions[] = { VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME, VK_KHR_RAY_QUERY_EXTENSION_NAME,
  VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME };

constexpr const char* remedy =
  "Install a driver for Vulkan 1.2 with shaderInt64: a GPU vendor's, or Mesa 22.3 or newer with lavapipe "
  "(Debian: mesa-vulkan-drivers).";

using Features = vk::StructureChain<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features,
  vk::PhysicalDeviceAccelerationStructureFeaturesKHR, vk::PhysicalDeviceRayQueryFeaturesKHR>;

bool HasExtensions(const vk::raii::PhysicalDevice& physical, std::span<const char* const> names)
{
  const auto extensions = physical.enumerateDeviceExtensionProperties();
  const auto has = [&](const char* name)
  {
    return std::any_of(extensions.begin(), extensions.end(),
      [&](const vk::ExtensionProperties& extension) { return std::string(extension.extensionName.data()) == name; });
  };
  return std::all_of(names.begin(), names.end(), has);
}

template <class Part>
Part FeaturesOf(const vk::raii::PhysicalDevice& physical)
{
  return physical.getFeatures2<vk::PhysicalDeviceFeatures2, Part>().template get<Part>();
}

template <class Part>
Part PropertiesOf(const vk::raii::PhysicalDevice& physical)
{
  return physical.getProperties2<vk::PhysicalDeviceProperties2, Part>().template get<Part>();
}

// Whether programs can query acceleration structures.
bool HasRayQueries(const vk::raii::PhysicalDevice& physical)
{
  return HasExtensions(physical, rayExtensions) &&
    FeaturesOf<vk::PhysicalDeviceAccelerationStructureFeaturesKHR>(physical).accelerationStructure &&
    FeaturesOf<vk::PhysicalDeviceRayQueryFeaturesKHR>(physical).rayQuery;
}

// Features that the device lacks to trace, in words; empty: none.
std::string Lacks(const vk::raii::PhysicalDevice& physical)
{
  const std::uint32_t version = physical.getProperties().apiVersion;
  if (version < VK_API_VERSION_1_2)
  {
    return "Vulkan 1.2: its driver has " + std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
      std::to_string(VK_API_VERSION_MINOR(version));
  }
  if (!physical.getFeatures2().features.shaderInt64)
  {
    return "the feature shaderInt64";
  }
  const auto features = FeaturesOf<vk::PhysicalDeviceVulkan12Features>(physical);
  if (!features.bufferDeviceAddress || !features.scalarBlockLayout)
  {
    return "the features bufferDeviceAddress and scalarBlockLayout";
  }
  // Programs/bindings.glsl declares them.
  const auto controls = PropertiesOf<vk::PhysicalDeviceVulkan12Properties>(physical);
  if (!controls.shaderRoundingModeRTEFloat32)
  {
    return "exact rounding (shaderRoundingModeRTEFloat32)";
  }
  if (!controls.shaderSignedZeroInfNanPreserveFloat32)
  {
    return "infinity and NaN (shaderSignedZeroInfNanPreserveFloat32)";
  }
  return {};
}

std::string DeviceName(const vk::raii::PhysicalDevice& physical)
{
  return physical.getProperties().deviceName.data();
}

// The index of the device that `wanted` names by number or part of its name. A number that no device has, such as 4090,
// is part of a name.
std::optional<std::size_t> FindNamed(const std::vector<vk::raii::PhysicalDevice>& devices, const std::string& wanted)
{
  if (wanted.find_first_not_of("0123456789") == std::string::npos && wanted.size() < 6)
  {
    const std::size_t index = std::stoul(wanted);
    if (index < devices.size())
    {
      return index;
    }
  }
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  for (std::size_t i = 0; i < devices.size(); ++i)
  {
    const std::string name = DeviceName(devices[i]);
    if (std::search(name.begin(), name.end(), wanted.begin(), wanted.end(), same) != name.end())
    {
      return i;
    }
  }
  return std::nullopt;
}

// Of the processes of an MPI program on this computer the number of this one, which launchers pass on: Open MPI, MPICH
// and Intel MPI, MVAPICH, Cray PALS, Flux, Slurm. 0: none does.
std::size_t LocalRank()
{
  for (const char* name : { "OMPI_COMM_WORLD_LOCAL_RANK", "MPI_LOCALRANKID", "MV2_COMM_WORLD_LOCAL_RANK",
         "PALS_LOCAL_RANKID", "FLUX_TASK_LOCAL_ID", "SLURM_LOCALID" })
  {
    if (const char* value = std::getenv(name))
    {
      return std::strtoul(value, nullptr, 10);
    }
  }
  return 0;
}

std::size_t ChooseDevice(const std::vector<vk::raii::PhysicalDevice>& devices)
{
  std::ostringstream found;
  std::vector<std::string> lacks;
  for (std::size_t i = 0; i < devices.size(); ++i)
  {
    lacks.push_back(Lacks(devices[i]));
    found << (i ? "; " : "") << i << ": " << DeviceName(devices[i])
          << (lacks[i].empty() ? "" : " (lacks " + lacks[i] + ")");
  }
  if (devices.empty())
  {
    found << "none";
  }

  const char* wanted = std::getenv("RTGLYPHS_DEVICE");
  if (wanted && *wanted)
  {
    const auto index = FindNamed(devices, wanted);
    if (!index)
    {
      throw Error("Ray Traced Glyphs: no Vulkan device matches RTGLYPHS_DEVICE='" + std::string(wanted) +
        "'. Found: " + found.str() + ". Unset it or name one of these.");
    }
    if (!lacks[*index].empty())
    {
      throw Error("Ray Traced Glyphs: the device of RTGLYPHS_DEVICE='" + std::string(wanted) + "' lacks " +
        lacks[*index] + ". Found: " + found.str() + ". " + remedy);
    }
    return *index;
  }

  // A GPU of its own memory first, then any other; else any device that traces.
  const auto rank = [&](std::size_t i)
  {
    const auto type = devices[i].getProperties().deviceType;
    return type == vk::PhysicalDeviceType::eDiscreteGpu ? 0 : type != vk::PhysicalDeviceType::eCpu ? 1 : 2;
  };
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < devices.size(); ++i)
  {
    if (lacks[i].empty() && (!best || rank(i) < rank(*best)))
    {
      best = i;
    }
  }
  if (!best)
  {
    throw Error("Ray Traced Glyphs: no Vulkan device can trace rays. Found: " + found.str() + ". " + remedy);
  }
  // Ranks share devices of one kind.
  std::vector<std::size_t> alike;
  for (std::size_t i = *best; i < devices.size(); ++i)
  {
    if (lacks[i].empty() && rank(i) == rank(*best) && DeviceName(devices[i]) == DeviceName(devices[*best]))
    {
      alike.push_back(i);
    }
  }
  return alike[LocalRank() % alike.size()];
}

std::uint32_t ChooseQueueFamily(const vk::raii::PhysicalDevice& physical)
{
  const auto families = physical.getQueueFamilyProperties();
  for (std::uint32_t i = 0; i < families.size(); ++i)
  {
    if (families[i].queueFlags & vk::QueueFlagBits::eCompute)
    {
      return i;
    }
  }
  throw Error("Ray Traced Glyphs: the Vulkan device '" + DeviceName(physical) + "' has no compute queue. " + remedy);
}

vk::raii::Device MakeDevice(const vk::raii::PhysicalDevice& physical, std::uint32_t queueFamily, bool rayQueries)
{
  Features enabled;
  enabled.get<vk::PhysicalDeviceFeatures2>().features.shaderInt64 = true;
  auto& vulkan12 = enabled.get<vk::PhysicalDeviceVulkan12Features>();
  vulkan12.bufferDeviceAddress = true;
  vulkan12.scalarBlockLayout = true;
  enabled.get<vk::PhysicalDeviceAccelerationStructureFeaturesKHR>().accelerationStructure = true;
  enabled.get<vk::PhysicalDeviceRayQueryFeaturesKHR>().rayQuery = true;
  if (!rayQueries)
  {
    enabled.unlink<vk::PhysicalDeviceAccelerationStructureFeaturesKHR>();
    enabled.unlink<vk::PhysicalDeviceRayQueryFeaturesKHR>();
  }

  const float priority = 1.0f;
  const vk::DeviceQueueCreateInfo queueInfo({}, queueFamily, 1, &priority);
  vk::DeviceCreateInfo info({}, queueInfo);
  if (rayQueries)
  {
    info.setPEnabledExtensionNames(rayExtensions);
  }
  info.pNext = &enabled.get<vk::PhysicalDeviceFeatures2>();
  return vk::raii::Device(physical, info);
}

// LLVM 21 may compile a shader wrongly for AVX-512 (Testing/Drivers/README.md). The driver's description names the
// compiler: "Mesa 26.1.6 (LLVM 21.1.8)".
bool MiscompilesAvx512(const vk::raii::PhysicalDevice& physical)
{
  const auto driver = PropertiesOf<vk::PhysicalDeviceDriverProperties>(physical);
  int version = 0;
  const char* compiler = std::strstr(driver.driverInfo, "LLVM ");
  return driver.driverID == vk::DriverId::eMesaLlvmpipe && compiler &&
    std::sscanf(compiler, "LLVM %d", &version) == 1 && version == 21;
}

// Vulkan's loader looks a device up in lists that instances and devices of other threads leave meanwhile.
std::mutex loaderMutex;

// Runs `work`, one at a time; throws failures of Vulkan's loader and drivers as rtg::Error.
template <class Work>
void StartingVulkan(Work&& work)
{
  try
  {
    const std::lock_guard<std::mutex> lock(loaderMutex);
    work();
  }
  catch (const Error&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw Error(std::string("Ray Traced Glyphs: Vulkan cannot be started (") + error.what() + "). " + remedy);
  }
}

} // namespace

Device::Device() = default;

void Device::Choose()
{
  try
  {
    this->state_ = std::make_unique<State>();
  }
  catch (const std::runtime_error&)
  {
    throw Error(
      "Ray Traced Glyphs: Vulkan's loader was not found (libvulkan.so.1, on Windows vulkan-1.dll). Install it "
      "(Debian: libvulkan1; Windows: with the driver). " +
      std::string(remedy));
  }
  State& state = *this->state_;
  const vk::ApplicationInfo application("RayTracedGlyphs", 1, "RayTracedGlyphs", 1, VK_API_VERSION_1_2);
  std::vector<vk::raii::PhysicalDevice> devices;
  const auto enumerate = [&]
  {
    devices.clear();
    state.instance = nullptr;
    try
    {
      state.instance = vk::raii::Instance(state.context, vk::InstanceCreateInfo({}, &application));
      devices = vk::raii::PhysicalDevices(state.instance);
    }
    catch (const vk::SystemError& error)
    {
      // Without any driver, which ChooseDevice says.
      if (error.code() != vk::Result::eErrorIncompatibleDriver &&
        error.code() != vk::Result::eErrorInitializationFailed)
      {
        throw;
      }
    }
    return ChooseDevice(devices);
  };
  std::size_t chosen = enumerate();
  constexpr const char* capabilities = "GALLIUM_OVERRIDE_CPU_CAPS";
  if (MiscompilesAvx512(devices[chosen]) && !std::getenv(capabilities))
  {
    // The driver is loaded anew, and reads it then: no AVX-512, but AVX2 all the same.
    SetEnvironment(capabilities, "avx");
    chosen = enumerate();
  }
  state.physical = std::move(devices[chosen]);
  state.name = DeviceName(state.physical);
  state.cpu = state.physical.getProperties().deviceType == vk::PhysicalDeviceType::eCpu;
}

void Device::Start()
{
  State& state = *this->state_;
  state.sharesMemory = state.cpu;
  state.queueFamily = ChooseQueueFamily(state.physical);
  state.rayQueries = HasRayQueries(state.physical);
  using Stage = vk::PipelineStageFlagBits;
  state.programStages = Stage::eComputeShader;
  if (state.rayQueries)
  {
    state.programStages |= Stage::eAccelerationStructureBuildKHR;
  }
  state.device = MakeDevice(state.physical, state.queueFamily, state.rayQueries);
  state.queue = state.device.getQueue(state.queueFamily, 0);
  const vk::DescriptorSetLayoutBinding block(
    0, vk::DescriptorType::eUniformBuffer, 1, vk::ShaderStageFlagBits::eCompute);
  state.frameLayout = vk::raii::DescriptorSetLayout(state.device, vk::DescriptorSetLayoutCreateInfo({}, block));
  state.programLayout = vk::raii::PipelineLayout(state.device, vk::PipelineLayoutCreateInfo({}, *state.frameLayout));
  state.programs = std::make_unique<ProgramLibrary>(state);
  state.memoryTypes = state.physical.getMemoryProperties();
  state.mostOfAllocation = PropertiesOf<vk::PhysicalDeviceVulkan11Properties>(state.physical).maxMemoryAllocationSize;
  constexpr const char* bufferSizes[] = { VK_KHR_MAINTENANCE_4_EXTENSION_NAME };
  if (HasExtensions(state.physical, bufferSizes))
  {
    state.mostOfBuffer = PropertiesOf<vk::PhysicalDeviceMaintenance4Properties>(state.physical).maxBufferSize;
  }
  if (state.rayQueries)
  {
    state.structureLimits = PropertiesOf<vk::PhysicalDeviceAccelerationStructurePropertiesKHR>(state.physical);
  }
}

Device::~Device()
{
  if (this->state_)
  {
    this->state_->programs.reset(); // what is being compiled makes devices, too
  }
  const std::lock_guard<std::mutex> lock(loaderMutex);
  this->state_.reset();
}

std::shared_ptr<Device> Device::Shared()
{
  static std::mutex mutex;
  // Kept alive by its users alone: at process exit no driver code runs after the driver was unloaded.
  static std::weak_ptr<Device> shared;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<Device> device = shared.lock();
  if (!device || device->Lost())
  {
    device = Another();
    shared = device;
  }
  return device;
}

std::shared_ptr<Device> Device::Another()
{
  const std::shared_ptr<Device> device(new Device);
  StartingVulkan(
    [&]()
    {
      device->Choose();
      device->Start();
    });
  return device;
}

Device::Choice Device::Chosen()
{
  Device looked;
  StartingVulkan([&]() { looked.Choose(); });
  return { looked.Name(), looked.IsCpu() };
}

std::string Device::Name() const
{
  return this->state_->name;
}

bool Device::IsCpu() const
{
  return this->state_->cpu;
}

bool Device::Lost() const
{
  return this->state_->lost;
}

std::uint64_t Device::HeldBytes() const
{
  return this->state_->memory.bytes;
}

void Device::State::Submit(const std::function<void(vk::raii::CommandBuffer&)>& record)
{
  Submission submission = this->TakeSubmission();
  vk::raii::CommandBuffer& command = submission.command;
  command.begin({ vk::CommandBufferUsageFlagBits::eOneTimeSubmit });
  record(command);
  command.end();
  ++this->submissions;

  const vk::CommandBuffer handle = *command;
  try
  {
    {
      const std::lock_guard<std::mutex> lock(this->queueMutex);
      this->queue.submit(vk::SubmitInfo({}, {}, handle), *submission.done);
    }
    static_cast<void>(this->device.waitForFences(*submission.done, true, std::numeric_limits<std::uint64_t>::max()));
  }
  catch (const vk::SystemError&)
  {
    // A submission may count as pending until a wait, and the caller's buffers go when this function ends.
    try
    {
      const std::lock_guard<std::mutex> lock(this->queueMutex);
      this->device.waitIdle();
    }
    catch (const vk::DeviceLostError&)
    {
      throw;
    }
    catch (const vk::SystemError&)
    {
      // The caller hears the first failure.
    }
    throw;
  }
  this->device.resetFences(*submission.done);
  submission.pool.reset();
  const std::lock_guard<std::mutex> lock(this->submissionMutex_);
  this->idleSubmissions_.push_back(std::move(submission));
}

Device::State::Submission Device::State::TakeSubmission()
{
  {
    const std::lock_guard<std::mutex> lock(this->submissionMutex_);
    if (!this->idleSubmissions_.empty())
    {
      Submission idle = std::move(this->idleSubmissions_.back());
      this->idleSubmissions_.pop_back();
      return idle;
    }
  }
  Submission made;
  made.pool = vk::raii::CommandPool(
    this->device, vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eTransient, this->queueFamily));
  vk::raii::CommandBuffers commands(this->device, { *made.pool, vk::CommandBufferLevel::ePrimary, 1 });
  made.command = std::move(commands.front());
  made.done = vk::raii::Fence(this->device, vk::FenceCreateInfo());
  return made;
}

void Device::State::ThrowOutOfMemory(const char* doing, const std::string& what)
{
  throw OutOfMemory("Ray Traced Glyphs: " + std::string(doing) + " failed on '" + this->name + "': " + what +
    ". Show fewer glyphs (GlyphMode, MaximumNumberOfGlyphs) or hide other data.");
}

void Device::State::Rethrow(const char* doing, const vk::SystemError& error)
{
  if (dynamic_cast<const vk::OutOfDeviceMemoryError*>(&error) || dynamic_cast<const vk::OutOfHostMemoryError*>(&error))
  {
    this->ThrowOutOfMemory(
      doing, "out of memory with " + std::to_string(this->memory.bytes.load() >> 20) + " MiB held");
  }
  std::string what = std::string(error.what()) + ". Update the driver, or choose another device with RTGLYPHS_DEVICE.";
  if (dynamic_cast<const vk::DeviceLostError*>(&error))
  {
    this->lost = true;
    what = "the Vulkan device was lost. The glyphs are sent again to a new one on the next render; if it recurs, lower "
           "SamplesPerPixel or update the driver.";
  }
  throw Error("Ray Traced Glyphs: " + std::string(doing) + " failed on '" + this->name + "': " + what);
}

} // namespace rtg
