// A module for clang-tidy: its checks look at what stands in our files alone. Without it they look at the headers of C++ and Eigen
// and at everything made from their templates, too, find nothing that is ours to mend, and take four times as long.
#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>
#include <clang/AST/ASTContext.h>
#include <clang/ASTMatchers/ASTMatchers.h>
#include <vector>

namespace {

using namespace clang;

// Not a check: where the tree of a unit begins, before anything below is looked at, it says what is below.
class OwnCode : public tidy::ClangTidyCheck {
 public:
  using ClangTidyCheck::ClangTidyCheck;

  void registerMatchers(ast_matchers::MatchFinder* finder) override {
    finder->addMatcher(ast_matchers::translationUnitDecl(), this);
  }

  void check(const ast_matchers::MatchFinder::MatchResult& unit) override {
    std::vector<Decl*> own;
    for (Decl* declaration : unit.Context->getTranslationUnitDecl()->decls()) {
      const SourceLocation place = unit.SourceManager->getExpansionLoc(declaration->getLocation());
      if (place.isValid() && !unit.SourceManager->isInSystemHeader(place)) {
        own.push_back(declaration);
      }
    }
    unit.Context->setTraversalScope(own);
  }
};

class OwnModule : public tidy::ClangTidyModule {
 public:
  void addCheckFactories(tidy::ClangTidyCheckFactories& factories) override {
    factories.registerCheck<OwnCode>("own-code");
  }
};

const tidy::ClangTidyModuleRegistry::Add<OwnModule> added("own", "Looks at our own files alone.");

}  // namespace
