// A Vulkan layer for tests that makes calls fail, as the file says that RTGLYPHS_FAULT names:
//   once                      the next vkQueueSubmit answers VK_ERROR_DEVICE_LOST, and the file is removed
//   always                    each vkQueueSubmit does so, while the file is there
//   FUNCTION N                the Nth call of FUNCTION from now on fails, and the file is removed
//   FUNCTION N always         that call and all further ones fail, while the file is there
// FUNCTION is vkQueueSubmit, which loses the device, or vkAllocateMemory, vkBindBufferMemory, vkMapMemory,
// vkCreateBuffer or vkCreateAccelerationStructureKHR, which answer VK_ERROR_OUT_OF_DEVICE_MEMORY, or mmap: vkMapMemory
// then answers VK_SUCCESS and maps nothing, as lavapipe's does where the computer has no memory left.
//
// Where a device is left when the process destroys what is static, the layer says so and ends the process with
// status 1.
//
// It makes devices lack what RTGLYPHS_LACKS names, one thing or several: see Properties(), Properties2() and
// Features2().
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <sys/mman.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <type_traits>

namespace
{

std::mutex mutex;
PFN_vkGetInstanceProcAddr nextInstanceProcAddr = nullptr;
PFN_vkGetPhysicalDeviceProperties nextProperties = nullptr;
PFN_vkGetPhysicalDeviceProperties2 nextProperties2 = nullptr;
PFN_vkGetPhysicalDeviceFeatures2 nextFeatures2 = nullptr;

struct Next
{
  PFN_vkGetDeviceProcAddr procAddr = nullptr;
  PFN_vkDestroyDevice destroyDevice = nullptr;
  PFN_vkQueueSubmit queueSubmit = nullptr;
  PFN_vkAllocateMemory allocateMemory = nullptr;
  PFN_vkBindBufferMemory bindBufferMemory = nullptr;
  PFN_vkMapMemory mapMemory = nullptr;
  PFN_vkCreateBuffer createBuffer = nullptr;
  PFN_vkCreateAccelerationStructureKHR createAccelerationStructure = nullptr;
};
std::map<void*, Next> devices; // by the loader's dispatch table, which a device and its queues share

// Drivers destroy what is static, too, which threads that compile for the device would still use.
struct End
{
  ~End()
  {
    if (!devices.empty())
    {
      std::fprintf(stderr, "FaultLayer: a device is left at the end of the process\n");
      std::_Exit(1);
    }
  }
} end;

void* Key(void* handle)
{
  return *static_cast<void**>(handle);
}

Next NextOf(void* handle)
{
  const std::lock_guard<std::mutex> lock(mutex);
  return devices.at(Key(handle));
}

// Whether this call of a function is to fail.
bool Due(const std::string& function)
{
  static std::string counted; // what the file said when the calls below were counted
  static long calls = 0;

  const std::lock_guard<std::mutex> lock(mutex);
  const char* path = std::getenv("RTGLYPHS_FAULT");
  std::ifstream file(path ? path : "");
  std::string order;
  if (!file || !std::getline(file, order))
  {
    counted.clear();
    return false;
  }
  if (order != counted)
  {
    counted = order;
    calls = 0;
  }

  std::istringstream words(order == "once" ? "vkQueueSubmit 1" : order == "always" ? "vkQueueSubmit 1 always" : order);
  std::string name, how;
  long number = 1;
  words >> name >> number >> how;
  if (name != function || ++calls < number)
  {
    return false;
  }
  if (how != "always")
  {
    counted.clear();
    std::remove(path);
  }
  std::fprintf(stderr, "FaultLayer: %s fails\n", function.c_str());
  return true;
}

template <class Link, class Info>
Link* FindLink(const Info* info, VkStructureType type)
{
  auto* link = const_cast<Link*>(static_cast<const Link*>(info->pNext));
  while (link && !(link->sType == type && link->function == VK_LAYER_LINK_INFO))
  {
    link = const_cast<Link*>(static_cast<const Link*>(link->pNext));
  }
  return link;
}

VKAPI_ATTR VkResult VKAPI_CALL CreateInstance(
  const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator, VkInstance* instance)
{
  auto* link = FindLink<VkLayerInstanceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
  if (!link)
  {
    return VK_ERROR_INITIALIZATION_FAILED;
  }
  nextInstanceProcAddr = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  auto create = reinterpret_cast<PFN_vkCreateInstance>(nextInstanceProcAddr(nullptr, "vkCreateInstance"));
  const VkResult result = create(info, allocator, instance);
  if (result == VK_SUCCESS)
  {
    nextProperties = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties>(
      nextInstanceProcAddr(*instance, "vkGetPhysicalDeviceProperties"));
    nextProperties2 = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties2>(
      nextInstanceProcAddr(*instance, "vkGetPhysicalDeviceProperties2"));
    nextFeatures2 = reinterpret_cast<PFN_vkGetPhysicalDeviceFeatures2>(
      nextInstanceProcAddr(*instance, "vkGetPhysicalDeviceFeatures2"));
  }
  return result;
}

bool Lacks(const char* name)
{
  const char* lacks = std::getenv("RTGLYPHS_LACKS");
  return lacks && std::strstr(lacks, name) != nullptr;
}

VKAPI_ATTR void VKAPI_CALL Properties(VkPhysicalDevice physical, VkPhysicalDeviceProperties* properties)
{
  nextProperties(physical, properties);
  if (Lacks("Vulkan 1.2"))
  {
    properties->apiVersion = VK_API_VERSION_1_1;
  }
}

VKAPI_ATTR void VKAPI_CALL Properties2(VkPhysicalDevice physical, VkPhysicalDeviceProperties2* properties)
{
  nextProperties2(physical, properties);
  for (auto* next = static_cast<VkBaseOutStructure*>(properties->pNext); next; next = next->pNext)
  {
    if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES)
    {
      auto& vulkan12 = *reinterpret_cast<VkPhysicalDeviceVulkan12Properties*>(next);
      vulkan12.shaderRoundingModeRTEFloat32 &= !Lacks("shaderRoundingModeRTEFloat32");
      vulkan12.shaderSignedZeroInfNanPreserveFloat32 &= !Lacks("shaderSignedZeroInfNanPreserveFloat32");
    }
  }
}

VKAPI_ATTR void VKAPI_CALL Features2(VkPhysicalDevice physical, VkPhysicalDeviceFeatures2* features)
{
  nextFeatures2(physical, features);
  features->features.shaderInt64 &= !Lacks("shaderInt64");
  for (auto* next = static_cast<VkBaseOutStructure*>(features->pNext); next; next = next->pNext)
  {
    if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR)
    {
      reinterpret_cast<VkPhysicalDeviceRayQueryFeaturesKHR*>(next)->rayQuery &= !Lacks("rayQuery");
    }
  }
}

VKAPI_ATTR VkResult VKAPI_CALL CreateDevice(
  VkPhysicalDevice physical, const VkDeviceCreateInfo* info, const VkAllocationCallbacks* allocator, VkDevice* device)
{
  auto* link = FindLink<VkLayerDeviceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
  if (!link)
  {
    return VK_ERROR_INITIALIZATION_FAILED;
  }
  const PFN_vkGetInstanceProcAddr instanceProcAddr = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  Next next;
  next.procAddr = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  auto create = reinterpret_cast<PFN_vkCreateDevice>(instanceProcAddr(VK_NULL_HANDLE, "vkCreateDevice"));
  const VkResult result = create(physical, info, allocator, device);
  if (result == VK_SUCCESS)
  {
    const auto find = [&next, device](auto& function, const char* name)
    { function = reinterpret_cast<std::decay_t<decltype(function)>>(next.procAddr(*device, name)); };
    find(next.destroyDevice, "vkDestroyDevice");
    find(next.queueSubmit, "vkQueueSubmit");
    find(next.allocateMemory, "vkAllocateMemory");
    find(next.bindBufferMemory, "vkBindBufferMemory");
    find(next.mapMemory, "vkMapMemory");
    find(next.createBuffer, "vkCreateBuffer");
    find(next.createAccelerationStructure, "vkCreateAccelerationStructureKHR");
    const std::lock_guard<std::mutex> lock(mutex);
    devices[Key(*device)] = next;
    std::fprintf(stderr, "FaultLayer: device made\n");
  }
  return result;
}

VKAPI_ATTR void VKAPI_CALL DestroyDevice(VkDevice device, const VkAllocationCallbacks* allocator)
{
  const Next next = NextOf(device);
  {
    const std::lock_guard<std::mutex> lock(mutex);
    devices.erase(Key(device));
  }
  next.destroyDevice(device, allocator);
}

VKAPI_ATTR VkResult VKAPI_CALL QueueSubmit(
  VkQueue queue, std::uint32_t count, const VkSubmitInfo* submits, VkFence fence)
{
  return Due("vkQueueSubmit") ? VK_ERROR_DEVICE_LOST : NextOf(queue).queueSubmit(queue, count, submits, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL AllocateMemory(
  VkDevice device, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks* allocator, VkDeviceMemory* memory)
{
  return Due("vkAllocateMemory") ? VK_ERROR_OUT_OF_DEVICE_MEMORY
                                 : NextOf(device).allocateMemory(device, info, allocator, memory);
}

VKAPI_ATTR VkResult VKAPI_CALL BindBufferMemory(
  VkDevice device, VkBuffer buffer, VkDeviceMemory memory, VkDeviceSize offset)
{
  return Due("vkBindBufferMemory") ? VK_ERROR_OUT_OF_DEVICE_MEMORY
                                   : NextOf(device).bindBufferMemory(device, buffer, memory, offset);
}

VKAPI_ATTR VkResult VKAPI_CALL MapMemory(
  VkDevice device, VkDeviceMemory memory, VkDeviceSize offset, VkDeviceSize size, VkMemoryMapFlags flags, void** data)
{
  if (Due("mmap"))
  {
    *data = MAP_FAILED;
    return VK_SUCCESS;
  }
  return Due("vkMapMemory") ? VK_ERROR_OUT_OF_DEVICE_MEMORY
                            : NextOf(device).mapMemory(device, memory, offset, size, flags, data);
}

VKAPI_ATTR VkResult VKAPI_CALL CreateBuffer(
  VkDevice device, const VkBufferCreateInfo* info, const VkAllocationCallbacks* allocator, VkBuffer* buffer)
{
  return Due("vkCreateBuffer") ? VK_ERROR_OUT_OF_DEVICE_MEMORY
                               : NextOf(device).createBuffer(device, info, allocator, buffer);
}

VKAPI_ATTR VkResult VKAPI_CALL CreateAccelerationStructure(VkDevice device,
  const VkAccelerationStructureCreateInfoKHR* info, const VkAllocationCallbacks* allocator,
  VkAccelerationStructureKHR* structure)
{
  return Due("vkCreateAccelerationStructureKHR")
    ? VK_ERROR_OUT_OF_DEVICE_MEMORY
    : NextOf(device).createAccelerationStructure(device, info, allocator, structure);
}

PFN_vkVoidFunction OwnDeviceFunction(const std::string& name)
{
  static const std::map<std::string, PFN_vkVoidFunction> own{
    { "vkDestroyDevice", reinterpret_cast<PFN_vkVoidFunction>(DestroyDevice) },
    { "vkQueueSubmit", reinterpret_cast<PFN_vkVoidFunction>(QueueSubmit) },
    { "vkAllocateMemory", reinterpret_cast<PFN_vkVoidFunction>(AllocateMemory) },
    { "vkBindBufferMemory", reinterpret_cast<PFN_vkVoidFunction>(BindBufferMemory) },
    { "vkMapMemory", reinterpret_cast<PFN_vkVoidFunction>(MapMemory) },
    { "vkCreateBuffer", reinterpret_cast<PFN_vkVoidFunction>(CreateBuffer) },
    { "vkCreateAccelerationStructureKHR", reinterpret_cast<PFN_vkVoidFunction>(CreateAccelerationStructure) },
  };
  const auto found = own.find(name);
  return found == own.end() ? nullptr : found->second;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetDeviceProcAddr(VkDevice device, const char* name)
{
  if (PFN_vkVoidFunction own = OwnDeviceFunction(name))
  {
    return own;
  }
  if (!std::strcmp(name, "vkGetDeviceProcAddr"))
  {
    return reinterpret_cast<PFN_vkVoidFunction>(GetDeviceProcAddr);
  }
  const std::lock_guard<std::mutex> lock(mutex);
  return devices.at(Key(device)).procAddr(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetInstanceProcAddr(VkInstance instance, const char* name)
{
  const std::map<std::string, PFN_vkVoidFunction> own{ { "vkGetInstanceProcAddr",
                                                         reinterpret_cast<PFN_vkVoidFunction>(GetInstanceProcAddr) },
    { "vkGetDeviceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(GetDeviceProcAddr) },
    { "vkCreateInstance", reinterpret_cast<PFN_vkVoidFunction>(CreateInstance) },
    { "vkGetPhysicalDeviceProperties", reinterpret_cast<PFN_vkVoidFunction>(Properties) },
    { "vkGetPhysicalDeviceProperties2", reinterpret_cast<PFN_vkVoidFunction>(Properties2) },
    { "vkGetPhysicalDeviceFeatures2", reinterpret_cast<PFN_vkVoidFunction>(Features2) },
    { "vkCreateDevice", reinterpret_cast<PFN_vkVoidFunction>(CreateDevice) } };
  const auto found = own.find(name);
  if (found != own.end())
  {
    return found->second;
  }
  if (PFN_vkVoidFunction function = OwnDeviceFunction(name))
  {
    return function;
  }
  return nextInstanceProcAddr ? nextInstanceProcAddr(instance, name) : nullptr;
}

} // namespace

extern "C" __attribute__((visibility("default"))) VkResult VKAPI_CALL vkNegotiateLoaderLayerInterfaceVersion(
  VkNegotiateLayerInterface* version)
{
  version->loaderLayerInterfaceVersion = 2;
  version->pfnGetInstanceProcAddr = GetInstanceProcAddr;
  version->pfnGetDeviceProcAddr = GetDeviceProcAddr;
  version->pfnGetPhysicalDeviceProcAddr = nullptr;
  return VK_SUCCESS;
}
