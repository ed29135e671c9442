#include "present/menu.h"

#include "present/theme.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace gh::present {
namespace {

enum KeyNumber { Enter = 1, Down, Up, Right, Delete };

// The menu in front of somebody, without a screen: ImGui lays out and takes input all the same.
class MenuTest : public ::testing::Test {
  protected:
    MenuTest() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
        io.KeyMap[ImGuiKey_Space] = Enter;
        io.KeyMap[ImGuiKey_DownArrow] = Down;
        io.KeyMap[ImGuiKey_UpArrow] = Up;
        io.KeyMap[ImGuiKey_RightArrow] = Right;
        io.KeyMap[ImGuiKey_Delete] = Delete;
        for (const char* what : {"walk forward", "crouch (quiet)", "aim a stone, and throw"})
            controls_.rows.push_back({what, {"right mouse", "Keypad Enter"}});
        while (controls_.rows.size() < 17) controls_.rows.push_back({"what the renderer sees", {"F4", ""}});
    }
    ~MenuTest() override { ImGui::DestroyContext(); }

    void show_in(float width, float height) {
        const float scale = ui_scale(width, height);
        apply_theme(load_fonts(scale), scale);
        ImGui::GetIO().Fonts->Build();
        ImGui::GetIO().DisplaySize = ImVec2(width, height);
        frames(3);
    }

    // The last answer that was one.
    MenuReply frames(int count) {
        MenuReply last;
        for (int i = 0; i < count; ++i) {
            ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
            ImGui::NewFrame();
            const MenuReply reply = menu_.draw(settings_, controls_, note_);
            if (reply.action != MenuAction::None) last = reply;
            ImGui::Render();
        }
        return last;
    }

    MenuReply press(KeyNumber key) {
        ImGui::GetIO().KeysDown[key] = true;
        const MenuReply down = frames(2);
        ImGui::GetIO().KeysDown[key] = false;
        const MenuReply up = frames(2);
        return down.action != MenuAction::None ? down : up;
    }

    // The n-th button of the first page.
    MenuReply choose(int n) {
        frames(3);
        for (int i = 0; i < n; ++i) press(Down);
        return press(Enter);
    }

    // That all of it is on the screen, and nothing has to be scrolled to.
    static void expect_fits(const char* name) {
        const ImGuiWindow* window = ImGui::FindWindowByName(name);
        ASSERT_NE(window, nullptr) << name;
        ASSERT_TRUE(window->Active) << name;
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        EXPECT_GE(window->Pos.x, 0.0f) << name;
        EXPECT_GE(window->Pos.y, 0.0f) << name;
        EXPECT_LE(window->Pos.x + window->Size.x, screen.x) << name << " at " << screen.x;
        EXPECT_LE(window->Pos.y + window->Size.y, screen.y) << name << " at " << screen.y;
        EXPECT_EQ(window->ScrollMax.x, 0.0f) << name << " at " << screen.x << "x" << screen.y;
        EXPECT_EQ(window->ScrollMax.y, 0.0f) << name << " at " << screen.x << "x" << screen.y;
    }

    Menu menu_;
    MenuSettings settings_;
    ControlsPage controls_;
    std::string note_ =
        "this run is recorded in /home/somebody/.local/share/glasshouse/recordings/"
        "foyer_2026-11-22_16-30-12_some_more_words_in_its_name.rec";
};

const ImVec2 kScreens[] = {{640, 360},   {800, 600},   {1024, 768}, {1280, 720},
                           {1920, 1080}, {2560, 1080}, {3840, 2160}};

TEST_F(MenuTest, EveryPageFitsEveryScreenAndCanBeRead) {
    for (const ImVec2 screen : kScreens) {
        show_in(screen.x, screen.y);
        EXPECT_GE(ImGui::GetIO().Fonts->Fonts[0]->FontSize, 11.0f) << "pixels, at " << screen.y;
        expect_fits("pause");
        choose(1);
        expect_fits("settings");
        menu_.go_back();
        choose(2);
        expect_fits("controls");
        controls_.waiting = KeyCell{2, 1};
        controls_.said =
            "Press the key or mouse button for \"back to the checkpoint\"; Esc leaves it as it is.";
        frames(2);
        expect_fits("controls");
        controls_.waiting.reset();
        controls_.said.clear();
        menu_.go_back();
        frames(2);
    }
}

TEST_F(MenuTest, ItsButtonsDoWhatTheySay) {
    show_in(1280, 720);
    EXPECT_EQ(choose(0).action, MenuAction::Resume);
    menu_ = Menu();
    EXPECT_EQ(press(Down).action, MenuAction::None);
    press(Down);
    press(Down);
    EXPECT_EQ(press(Enter).action, MenuAction::RestartLevel);
    press(Down);
    EXPECT_EQ(press(Enter).action, MenuAction::Quit);
}

TEST_F(MenuTest, EscapeGoesBackPageByPage) {
    show_in(1280, 720);
    EXPECT_FALSE(menu_.go_back()) << "the first page is left by leaving the menu";
    choose(2);
    EXPECT_TRUE(menu_.go_back());
    EXPECT_FALSE(menu_.go_back());
}

TEST_F(MenuTest, AKeyIsAskedForByTheCellThatIsChosen) {
    show_in(1280, 720);
    choose(2);
    press(Down);
    press(Right);
    const MenuReply reply = press(Enter);
    EXPECT_EQ(reply.action, MenuAction::AskForKey);
    EXPECT_EQ(reply.cell.row, 1u);
    EXPECT_EQ(reply.cell.place, 1u);
    const MenuReply removed = press(Delete);
    EXPECT_EQ(removed.action, MenuAction::RemoveKey);
    EXPECT_EQ(removed.cell.row, 1u);
}

TEST_F(MenuTest, AfterAKeyWasGivenTheKeyboardGoesOnFromThere) {
    show_in(1280, 720);
    choose(2);
    press(Down);
    ASSERT_EQ(press(Enter).action, MenuAction::AskForKey);
    controls_.waiting = KeyCell{1, 0};
    press(Right);  // the key that was asked for
    controls_.waiting.reset();
    frames(3);
    press(Down);
    EXPECT_EQ(press(Enter).cell, (KeyCell{2, 0}));
}

// Space, the arrows and the mouse are keys like others: while one is asked for they must move nothing.
TEST_F(MenuTest, WhileAKeyIsAskedForNothingElseCanBeChosen) {
    show_in(1280, 720);
    choose(2);
    controls_.waiting = KeyCell{0, 0};
    frames(1);
    for (const KeyNumber key : {Enter, Down, Right, Delete})
        EXPECT_EQ(press(key).action, MenuAction::None) << key;
    ImGuiIO& io = ImGui::GetIO();
    const ImGuiWindow* window = ImGui::FindWindowByName("controls");
    for (float x = 0.05f; x < 1.0f; x += 0.1f) {
        for (float y = 0.1f; y < 1.0f; y += 0.05f) {
            io.MousePos = ImVec2(window->Pos.x + window->Size.x * x, window->Pos.y + window->Size.y * y);
            io.MouseDown[0] = true;
            EXPECT_EQ(frames(1).action, MenuAction::None);
            io.MouseDown[0] = false;
            EXPECT_EQ(frames(1).action, MenuAction::None);
        }
    }
}

TEST(UiScale, FollowsTheWindowAndKeepsLettersReadable) {
    EXPECT_FLOAT_EQ(ui_scale(1280, 720), 1.0f);
    EXPECT_FLOAT_EQ(ui_scale(3840, 2160), 3.0f);
    EXPECT_FLOAT_EQ(ui_scale(640, 360), 0.65f);
    EXPECT_FLOAT_EQ(ui_scale(700, 2000), 0.65f) << "a narrow window has no room for more";
    EXPECT_LT(ui_scale(320, 180), 0.35f) << "and a tiny one none for that";
}

}  // namespace
}  // namespace gh::present
