// A command line for the library of dxc beside it: the file comes first, dxc's own flags after it.
// Complaints go to the standard output.

#include "WinAdapter.h"

#include "dxcapi.h"

#include <cstdio>
#include <dlfcn.h>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

int main(int count, char **given) {
    void *library = dlopen("libdxcompiler.so", RTLD_NOW);
    if (count < 2 || !library) {
        std::puts(count < 2 ? "dxc FILE FLAGS..." : dlerror());
        return 2;
    }
    auto make = reinterpret_cast<DxcCreateInstanceProc>(dlsym(library, "DxcCreateInstance"));
    IDxcCompiler3 *compiler = nullptr;
    make(CLSID_DxcCompiler, IID_PPV_ARGS(&compiler));
    std::ifstream file(given[1]);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    std::vector<std::wstring> words;
    std::vector<const wchar_t *> arguments;
    for (int at = 1; at < count; ++at) {
        const std::string word = given[at];
        words.emplace_back(word.begin(), word.end());
    }
    for (const std::wstring &word : words) {
        arguments.push_back(word.c_str());
    }
    const DxcBuffer source{text.data(), text.size(), DXC_CP_UTF8};
    IDxcResult *result = nullptr;
    if (!compiler || FAILED(compiler->Compile(&source, arguments.data(), arguments.size(), nullptr,
                                              IID_PPV_ARGS(&result)))) {
        std::puts("dxc did not run");
        return 2;
    }
    IDxcBlobUtf8 *complaints = nullptr;
    result->GetOutput(DXC_OUT_ERRORS, IID_PPV_ARGS(&complaints), nullptr);
    if (complaints && complaints->GetStringLength() > 0) {
        std::fputs(complaints->GetStringPointer(), stdout);
    }
    HRESULT status = E_FAIL;
    result->GetStatus(&status);
    return FAILED(status) ? 1 : 0;
}
