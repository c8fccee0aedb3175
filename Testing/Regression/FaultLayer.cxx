// A Vulkan layer for tests that loses the device: while the file that RTGLYPHS_FAULT names exists, vkQueueSubmit
// removes it and answers VK_ERROR_DEVICE_LOST. A file that says "always" stays.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <string>

namespace
{

std::mutex mutex;
PFN_vkGetInstanceProcAddr nextInstanceProcAddr = nullptr;

struct Next
{
  PFN_vkGetDeviceProcAddr procAddr = nullptr;
  PFN_vkQueueSubmit queueSubmit = nullptr;
};
std::map<void*, Next>
  devices; // by the loader's dispatch table, which a device and its queues share

void* Key(void* handle)
{
  return *static_cast<void**>(handle);
}

bool Due()
{
  const char* path = std::getenv("RTGLYPHS_FAULT");
  std::ifstream file(path ? path : "");
  if (!file)
  {
    return false;
  }
  std::string word;
  file >> word;
  if (word != "always")
  {
    std::remove(path);
  }
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
  auto* link =
    FindLink<VkLayerInstanceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
  if (!link)
  {
    return VK_ERROR_INITIALIZATION_FAILED;
  }
  nextInstanceProcAddr = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  auto create =
    reinterpret_cast<PFN_vkCreateInstance>(nextInstanceProcAddr(nullptr, "vkCreateInstance"));
  return create(info, allocator, instance);
}

VKAPI_ATTR VkResult VKAPI_CALL CreateDevice(VkPhysicalDevice physical,
  const VkDeviceCreateInfo* info, const VkAllocationCallbacks* allocator, VkDevice* device)
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
  auto create =
    reinterpret_cast<PFN_vkCreateDevice>(instanceProcAddr(VK_NULL_HANDLE, "vkCreateDevice"));
  const VkResult result = create(physical, info, allocator, device);
  if (result == VK_SUCCESS)
  {
    next.queueSubmit = reinterpret_cast<PFN_vkQueueSubmit>(next.procAddr(*device, "vkQueueSubmit"));
    const std::lock_guard<std::mutex> lock(mutex);
    devices[Key(*device)] = next;
    std::fprintf(stderr, "FaultLayer: device made\n");
  }
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL QueueSubmit(
  VkQueue queue, std::uint32_t count, const VkSubmitInfo* submits, VkFence fence)
{
  if (Due())
  {
    std::fprintf(stderr, "FaultLayer: device lost\n");
    return VK_ERROR_DEVICE_LOST;
  }
  PFN_vkQueueSubmit next;
  {
    const std::lock_guard<std::mutex> lock(mutex);
    next = devices.at(Key(queue)).queueSubmit;
  }
  return next(queue, count, submits, fence);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetDeviceProcAddr(VkDevice device, const char* name)
{
  if (!std::strcmp(name, "vkQueueSubmit"))
  {
    return reinterpret_cast<PFN_vkVoidFunction>(QueueSubmit);
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
  const std::map<std::string, PFN_vkVoidFunction> own{
    { "vkGetInstanceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(GetInstanceProcAddr) },
    { "vkGetDeviceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(GetDeviceProcAddr) },
    { "vkCreateInstance", reinterpret_cast<PFN_vkVoidFunction>(CreateInstance) },
    { "vkCreateDevice", reinterpret_cast<PFN_vkVoidFunction>(CreateDevice) },
    { "vkQueueSubmit", reinterpret_cast<PFN_vkVoidFunction>(QueueSubmit) }
  };
  const auto found = own.find(name);
  if (found != own.end())
  {
    return found->second;
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
