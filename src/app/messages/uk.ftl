### Усі речення сторінки українською. Англійський оригінал з тими самими назвами — у файлі en.ftl.
### Перекладено без пілота, який літає й говорить українською; виправлення вітаються (docs/translating.md).

## Moving servos and motor from the page.

bench_slots = Рух до
bench_elsewhere = Сервоприводи й двигун працюють із { $memory }, вибраною для наступного польоту. Щоб рухати їх, покажіть { $memory }.
bench_trim = Регулювання: { $slot }
bench_at = Сервоприводи тут: { $slot }
bench_atNone = Невідомо, де стоять сервоприводи.
bench_moveMaybe = Відповідь не надійшла. Сервоприводи все одно могли зрушити. Подивіться на модель.
bench_unlocked = Двигун розблоковано. Пропелер може запуститися.
bench_unlockMaybe = Відповідь не надійшла. Двигун усе одно може бути розблокований. Тримайтеся подалі від пропелера.
bench_jumped = Таймер підтвердив перехід.
bench_here = сервоприводи тут
bench_waits = Чекає на запис.
bench_bring = Перевести сервоприводи сюди: { $slot }
bench_follow = Сервоприводи повторюють зміни
bench_followHint = Спершу сторінка зчитує таймер і робить резервну копію. Далі кожне положення, яке ви змінюєте в рядку, де стоять сервоприводи, одразу записується в таймер, і його сервопривід рухається.
bench_followingNow = Сервоприводи повторюють зміни: положення, яке ви змінюєте в рядку, де вони стоять, одразу записується в таймер.
bench_stopFollowing = Зупинити повторення
bench_ended_over = Сервоприводи більше не повторюють зміни.
bench_ended_memory = Сервоприводи більше не повторюють зміни: поточною є або може бути інша пам’ять.
bench_ended_strayed = Поки сервоприводи повторювали зміни, поточною стала інша пам’ять. Частина положень могла потрапити в неї: перегляньте її всю, перш ніж летіти з нею.
bench_ended_unlike = Сервоприводи більше не повторюють зміни: таймер не зробив того, що підтвердив.
bench_ended_failed = Сервоприводи більше не повторюють зміни: таймер не відповів.
bench_notTaken = { $field }: у таймері { $held }, а не { $wanted }.
bench_beside =
    { $more ->
        [0] Також змінилося: { $named }.
        [one] Також змінилося: { $named }; і ще { $more } значення.
        [few] Також змінилося: { $named }; і ще { $more } значення.
       *[many] Також змінилося: { $named }; і ще { $more } значень.
    }
bench_triedHere =
    { $more ->
        [0] Випробувано: { $named }.
        [one] Випробувано: { $named }; і ще { $more } положення.
        [few] Випробувано: { $named }; і ще { $more } положення.
       *[many] Випробувано: { $named }; і ще { $more } положень.
    }
bench_triedAndWaiting =
    { $waiting ->
        [0] { $tried } випробувано в таймері
        [one] { $tried } випробувано в таймері, { $waiting } чекає на запис
        [few] { $tried } випробувано в таймері, { $waiting } чекають на запис
       *[many] { $tried } випробувано в таймері, { $waiting } чекають на запис
    }
bench_triedIn = Положення випробувано тут: { $memory }.
bench_decide = Залишити випробуване чи повернути те, що таймер містив раніше?
bench_keep = Залишити
bench_putBack = Повернути…
bench_unlock = UNLOCK: тримати
bench_unlockHold = Тримайте далі
bench_unlockHint = Пропелер може запуститися. Тримайте модель, руки подалі від пропелера, тоді натисніть і тримайте.
bench_experimental = Експериментально
bench_jumpHint = Перехід до функції після раннього DT. Його точна дія не описана: сервоприводи можуть зрушити.
bench_jump = Перехід…
bench_jumpSure = Надіслати перехід зараз

## The log of flights.

flights_title = Польоти
flights_empty_title = Ще немає жодного польоту.
flights_empty_advice = Зчитайте або запишіть таймер, тоді натисніть «{ flights_flying_button }».
flights_failed = Браузер зараз не може прочитати бібліотеку. Закрийте інші вкладки цієї сторінки й спробуйте ще раз.
flights_flying_button = Лечу з цим
flights_flying_purpose = Вносить у журнал політ із тим, що містить таймер.
flights_flying_logged = Політ внесено: { $time }
flights_flying_fillIn = Заповнити
flights_flying_again = Летіти з цим знову
flights_row_round = Тур { $round }
flights_row_wind = { $wind } м/с
flights_row_temperature = { $degrees } °C
flights_row_noResult = без результату
flights_row_changed = змінено: { $values }
flights_row_otherTimer = інший таймер
flights_totals_flights =
    { $count ->
        [one] { $count } політ
        [few] { $count } польоти
       *[many] { $count } польотів
    }
flights_totals_best = найкращий { $time }
flights_totals_average = середній { $time }
flights_filter_of = Польоти: { $name }
flights_filter_clear = Показати всі
flights_form_title = Політ
flights_form_result = Результат
flights_form_resultHint = Секунди або хвилини, як-от 2:58.
flights_form_readAs = { $time }, { $seconds } с
flights_form_propose = Занотувати: { $facts }
flights_form_full = Повний тур, 180 с
flights_form_round = Тур
flights_form_flyOff = Fly-off
flights_form_wind = Вітер
flights_form_windUnit = м/с
flights_form_temperature = Температура
flights_form_temperatureUnit = °C
flights_form_when = Дата, місце, модель
flights_form_date = Дата й час
flights_form_noOffset = Часовий пояс поля невідомий: це час цього пристрою.
flights_form_place = Місце
flights_form_flown = З чим летіли
flights_form_open = Відкрити програму
flights_form_unreadable_not-a-number = Це не число.
flights_form_unreadable_not-a-time = Це не час: введіть секунди, як-от 178, або хвилини, як-от 2:58.
flights_form_unreadable_too-fine = { unreadable_too-fine }
flights_form_range = Від { $min } до { $max } { $unit }.
flights_form_shortDt = У цьому польоті DT був { $dt }.
flights_score_open = Картка результатів
flights_score_maximum = Максимум кожного туру
flights_score_none = Без максимуму кожен результат зараховується повністю.
flights_score_maximumOf = Максимум: { $round }
flights_score_counted = Залік (с)
flights_score_notCounted = не залічено
flights_score_count = Залічити
flights_score_noRound = без туру
flights_score_total = Разом
flights_score_copy = Копіювати як текст
flights_csv_save = Зберегти як таблицю (CSV)
flights_csv_columns_date = Дата
flights_csv_columns_time = Час
flights_csv_columns_zone = Часовий пояс
flights_csv_columns_place = Місце
flights_csv_columns_model = Модель
flights_csv_columns_setting = Програма
flights_csv_columns_timerClass = Клас таймера
flights_csv_columns_memory = Пам’ять
flights_csv_columns_dt = DT (с)
flights_csv_columns_motorStop = Зупинка двигуна (с)
flights_csv_columns_wind = Вітер (м/с)
flights_csv_columns_temperature = Температура (°C)
flights_csv_columns_round = Тур
flights_csv_columns_result = Результат (с)
flights_csv_columns_maximum = Максимум (с)
flights_csv_columns_note = Нотатка
flights_section_all = Усі її польоти

## Values that are unusual, or cannot be written.

findings_time-not-whole = { unreadable_not-a-whole-number }
findings_time-out-of-range = Має бути від { $min } до { $max }.
findings_position-not-whole = { unreadable_not-a-whole-number }
findings_position-out-of-range = Має бути від { $min } до { $max }.
findings_throttle-not-whole = { unreadable_not-a-whole-number }
findings_throttle-out-of-range = Має бути від { $min } до { $max }.
findings_position-as-read = Зчитано { $value }, це вище за останній крок, { $max }. Так і лишиться, якщо ви не зміните.
findings_time-falls = Це раніше за функцію вище ({ $previous }).
findings_time-repeats = Той самий час, що й у функції вище: { $previous }.
findings_position-never-reached = Той самий час, що й у функції вище: { $previous }. Положення функції вище ніколи не досягаються.
findings_motor-stop-after-dt = Двигун зупиняється після DT ({ $dt }): модель опускається, а двигун працює.
findings_motor-run-long = Двигун працює довше за межу для F1Q, { $limit }.
findings_time-outside-manual = Посібник дозволяє від { $min } до { $max }.
findings_time-too-fine = У посібнику крок { $step }: таймер може округлити.
findings_dt-short = Коротше, ніж { $limit }.
findings_dt-moves-nothing = На DT не рухається жоден сервопривід: таймер не опускає модель.
findings_throttle-unusual = Понад { $limit } — незвично. Одиниця невідома.
findings_class-unknown = Клас «{ $timerClass }» невідомий: його правил не перевірено.

## Why a text in a field is no value.

unreadable_empty = Порожньо: введіть значення.
unreadable_not-a-time = Це не час: введіть секунди, як-от 12,5, або хвилини, як-от 2:05.
unreadable_too-fine = Точніше за соту частку секунди.
unreadable_not-a-whole-number = Має бути ціле число.
unreadable_ambiguous = Це можна прочитати по-різному: виберіть одне.

## For a page that cannot reach a timer here.

restWorks = Усе, крім з’єднання, працює й тут.

## What an Android phone needs.

firstVersions_android = 148
firstVersions_androidBluetooth = 138
firstVersions_lastBluetoothOnly = 147
firstVersions_androidCable = 17
android = Chrome { firstVersions_android } або новіший (від { firstVersions_androidBluetooth } до { firstVersions_lastBluetoothOnly } лише через Bluetooth); для кабелю потрібен Android { firstVersions_androidCable }

## For every browser about which nothing more is known. docs/connection.md names the first versions.

unsupportedHere_title = Цей браузер не має доступу до таймера.
unsupportedHere_advice = На комп’ютері візьміть сучасний Chrome, Edge, Opera або Firefox; на телефоні — Chrome на Android. { restWorks }

## Replaces the sentence above where the browser's name tells more.

unsupported_brave_title = Brave має доступ до таймера, лише якщо ви дозволите.
unsupported_brave_advice = Відкрийте brave://flags/#brave-web-serial-api, виберіть Enabled і натисніть Relaunch. { restWorks }
unsupported_ios_title = Жоден браузер на iPhone чи iPad не має доступу до таймера.
unsupported_ios_advice = Візьміть комп’ютер або Chrome на телефоні з Android. { restWorks }
unsupported_android_title = { unsupportedHere_title }
unsupported_android_advice = На Android потрібен { android }. { restWorks }

## What a saved program held before it was saved over.

versions_title = Попередні версії
versions_until = До{"\u00a0"}{ $when }
versions_changed =
    { $more ->
        [0] тоді { $change }
       *[other] тоді { $change } і ще { $more }
    }
versions_otherLayout = тоді значення для іншого таймера
versions_same = Збережена програма містить це зараз.
versions_goBack = Повернутися до цієї

## Two programs side by side.

compare_title = Порівняння
compare_open = Порівняти…
compare_second = з
compare_screen = На екрані
compare_timer = Таймер, { $memory }
compare_groups_now = Зараз
compare_groups_settings = Збережені програми
compare_setting = { $model } · { $name }
compare_backup = { $memory } · { $when }
compare_backupOf = { $model } · { $memory } · { $when }
compare_nothing = На цьому пристрої немає іншої програми такого класу й будови.
compare_take = Узяти
compare_takeOf = Узяти { $value }: { $field }
compare_takeHint = «Узяти» копіює значення в програму на екрані.

## How a backup differs from what its timer holds.

modelBackups_same = як у таймері: { $when }
modelBackups_differs =
    { $count ->
        [one] { $count } значення відрізняється від таймера: { $when }
        [few] { $count } значення відрізняються від таймера: { $when }
       *[many] { $count } значень відрізняються від таймера: { $when }
    }
modelBackups_now = зараз


## Undo, redo, and edits of many fields at once.

edits_redoButton = Повторити
edits_undo = Відмінити: { $step }
edits_redo = Повторити: { $step }
edits_steps_change = зміна: { $what }
edits_steps_shift = зсув від: { $what }, на { $by }
edits_steps_step-servo = { $what } на { $steps }
edits_steps_step-servo-from = { $what } на { $steps }, від: { $from }
edits_steps_paste = вставлення: { $count }
edits_steps_fill = заповнення вниз: { $count }
edits_steps_revert-all = повернення всього
edits_steps_open = відкриття: { $what }
edits_steps_keep-tried = залишення випробуваного
edits_opened = «{ $name }»
edits_openedUnnamed = інша програма
edits_refused_start = Старт не має часу, який можна змінити.
edits_refused_later-out-of-range = Пізніша функція вийшла б за межі від { $min } до { $max }.
edits_refused_unreadable = Заважає текст, який не є значенням. Спершу виправте його.
edits_refused_interval-disagrees = Цей проміжок не узгоджується з часом двох рядків.
edits_refused_no-place = У програмі немає такого місця.
edits_refused_twice = Це місце трапляється двічі, з різними значеннями.
edits_refused_too-large = Таблиця завелика: читається щонайбільше { $cells } комірок. Решту пропущено.
edits_beforeLaunch = Це було б до старту.
edits_nothingDone = Нічого не змінено.
edits_cells =
    { $count ->
        [one] { $count } значення
        [few] { $count } значення
       *[many] { $count } значень
    }
edits_change = { $field }: { $from } → { $to }
edits_field_putBack = Повернути: { $field }
edits_field_putBackTo = { $field }: повернути { $figure }
edits_sheet_title = Клавіші: { $field }
edits_sheet_erase = Стерти останню цифру
edits_sheet_putBack = Повернути
edits_sheet_selectRange = Діапазон
edits_sheet_goTo = Перейти: { $name }
edits_table_explain = Що означають значення
edits_table_interval = Через
edits_table_countedFrom = від: { $row }
edits_table_switch = Час або Через
edits_table_intervalOf = { $slot }, проміжок
edits_table_range_title = Вибраний діапазон
edits_table_range_pick = Тепер торкніться іншої комірки.
edits_table_range_size = { $cells }, { $columns }
edits_table_range_functions =
    { $count ->
        [one] { $count } функція
        [few] { $count } функції
       *[many] { $count } функцій
    }
edits_table_range_rows =
    { $count ->
        [one] { $count } рядок
        [few] { $count } рядки
       *[many] { $count } рядків
    }
edits_table_range_columns =
    { $count ->
        [one] { $count } стовпець
        [few] { $count } стовпці
       *[many] { $count } стовпців
    }
edits_table_range_paste = Вставити…
edits_table_range_fillDown = Заповнити вниз
edits_table_range_clipboardClosed = Немає нічого для вставлення, що ця сторінка може бачити. Торкніться першого поля й вставте там.
edits_table_tools = Інструменти: { $name }
edits_stepServo_title = Усі положення { $servo }
edits_stepServo_now = Зараз { $position }
edits_stepServo_nowRange = Зараз від { $lowest } до { $highest }
edits_stepServo_by = На скільки кроків
edits_stepServo_step = Зрушити
edits_stepServo_which = Які
edits_stepServo_all = Усі функції
edits_stepServo_from = Починаючи з: { $slot }
edits_stepServo_stops =
    { $count ->
        [one] { $steps }: { $what } зупиняється на { $at }.
        [few] { $steps }: { $what } зупиняються на { $at }.
       *[many] { $steps }: { $what } зупиняються на { $at }.
    }
edits_shift_open = Зсунути…
edits_shift_from =
    { $isLast ->
        [true] { $row }
       *[false] { $row } і всі далі
    }
edits_shift_by = На скільки секунд
edits_shift_earlier = Раніше
edits_shift_later = Пізніше
edits_shift_moveDt = Зсунути й DT
edits_shift_function = функція { $number }
edits_shift_functionRange = функції { $first }–{ $last }
edits_shift_functions = функції { $numbers }
edits_shift_moved =
    { $later ->
        [true] Зсунуто на { $time }{" "}с пізніше
       *[false] Зсунуто на { $time }{" "}с раніше
    }
edits_pasting_asks = Ці назви невідомі. Скажіть, що вони означають:
edits_pasting_choose = Виберіть
edits_pasting_leaveOut = Пропустити
edits_pasting_table = Що куди йде
edits_pasting_lead =
    { $count ->
        [0] Це нічого не змінює.
        [one] Це змінює { $count } значення.
        [few] Це змінює { $count } значення.
       *[many] Це змінює { $count } значень.
    }
edits_pasting_reading = { $field }: «{ $text }» читається як { $time }.
edits_pasting_problems = Це не можна вставити:
edits_pasting_place = Рядок { $row }, стовпець { $column } скопійованого тексту
edits_pasting_problem = { $place }: { $reason }
edits_pasting_problemOf = { $place }, «{ $text }»: { $reason }
edits_pasting_apply = Вставити
edits_presets_title = Кнопки DT
edits_presets_use = DT { $time }
edits_presets_refused = Введіть часи, як-от 20 с або 2:30, до 10:55 хв, щонайбільше 24.
edits_fix = Задати { $value }
edits_fixOf = Задати { $value }: { $field }

## The library as files: export, import, and the reminder to export.

files_export_all = Експорт усього…
files_export_one = Експорт…
files_export_downloaded = «{ $name }» іде до завантажень: { $what }. Переконайтеся, що файл там є.
files_export_without = без такого: { $kind }
files_export_kinds_models = моделі
files_export_kinds_settings = програми
files_export_kinds_flights = польоти
files_export_partly = «{ $name }» неповний. Він містить: { $what }. Браузер зараз не може прочитати: { $missing }. Закрийте інші вкладки цієї сторінки й зробіть експорт ще раз.
files_export_and = { $first } і { $next }
files_export_tooLarge = Бібліотека завелика для одного файлу. Зробіть експорт моделей по одній.
files_export_failed = Файл не вдалося створити. Завантажте сторінку знову й спробуйте ще раз.
files_import_button = Імпорт…
files_import_title = Імпорт: { $name }
files_import_lead = Збережено { $date }. Містить: { $what }.
files_import_leadNothing = Збережено { $date }. Не містить нічого.
files_import_ignored =
    { $count ->
        [one] { $count } елемент належить до новішої версії цієї сторінки, його пропущено.
        [few] { $count } елементи належать до новішої версії цієї сторінки, їх пропущено.
       *[many] { $count } елементів належать до новішої версії цієї сторінки, їх пропущено.
    }
files_import_nothing = Усе це у вас уже є.
files_import_differs = Що відрізняється
files_import_ways_newer = Узяти новіше
files_import_ways_both = Лишити обидва
files_import_itself = сама модель
files_import_flightOf = політ { $day }
files_import_wayText_newer = Те, що тут новіше або має ту саму дату, лишається.
files_import_wayText_both = Лишаються обидва. До назви того, що з файлу, додається число.
files_import_unknownModel = Модель, якої тут немає
files_import_group_fresh = Нове: { $what }
files_import_group_same = Те саме: { $what }
files_import_group_fileNewer = Новіше у файлі: { $what }
files_import_group_deviceNewer = Не новіше у файлі: { $what }
files_import_group_fileName = { $file } (тут: { $here })
files_import_take =
    { $count ->
        [0] Немає що імпортувати
       *[other] Імпортувати { $count }
    }
files_import_allStays = У файлі немає нічого новішого. Щоб усе-таки імпортувати, виберіть «{ files_import_ways_both }».
files_import_done = Імпортовано з «{ $name }»: { $what }.
files_import_undo = Відмінити імпорт
files_import_undone = Імпорт відмінено. Пізніші зміни лишаються.
files_refused_title = { $name } не можна імпортувати
files_refused_nothing = Нічого не імпортовано.
files_refused_again = Зробіть експорт файлу ще раз або попросіть новий у того, хто його надіслав.
files_refused_fault = Рядок{"\u00a0"}{ $line }: є { $found }.
files_refused_faultIn = Рядок{"\u00a0"}{ $line }, { $place }: є { $found }.
files_refused_wanted = Очікувалося:
files_refused_place_entry =
    { $kind ->
        [models] Модель «{ $name }»
        [settings] Програма «{ $name }»
       *[flights] Політ «{ $name }»
    }
files_refused_place_unnamed =
    { $kind ->
        [models] Модель { $number } у файлі
        [settings] Програма { $number } у файлі
       *[flights] Політ { $number } у файлі
    }
files_refused_place_function = функція { $number }
files_refused_damaged = Файл пошкоджений або неповний.
files_refused_files_too-large = Файл завеликий для бібліотеки.
files_refused_files_gone = Файл не вдалося прочитати. Виберіть його ще раз.
files_refused_files_several = Імпортуйте по одному файлу.
files_refused_format = Це не файл бібліотеки Sidus Timer.
files_refused_newer = Його створила новіша версія цієї сторінки. Завантажте сторінку знову, коли буде мережа.
files_reminder =
    { $changes ->
        [one] { $changes } зміна бібліотеки є лише на цьому пристрої. Якщо ви його втратите, її поверне тільки файл.
        [few] { $changes } зміни бібліотеки є лише на цьому пристрої. Якщо ви його втратите, їх поверне тільки файл.
       *[many] { $changes } змін бібліотеки є лише на цьому пристрої. Якщо ви його втратите, їх поверне тільки файл.
    }

## For the time before the other sentences are loaded.

first_failed = Сторінка неповна. Чи є мережа?
first_again = Завантажити знову

## What a system shows of the installed page: public/manifest.webmanifest has the same in English.

manifest_description = Налаштовує таймери Sidus F1Q, F1B і F1E для вільнолітаючих моделей: зчитує, що містить таймер, приймає ваші зміни, записує їх, зчитує повторно й порівнює. Тримає ваші моделі й програми на цьому пристрої. Працює без мережі.
manifest_connect = З’єднати таймер
manifest_connectShort = З’єднати
manifest_connectWhat = Початок, де можна з’єднатися
manifest_library = Бібліотека
manifest_libraryWhat = Моделі та їхні програми
manifest_simulated = Симульований таймер
manifest_simulatedWhat = Початок, де є симульовані таймери
manifest_pictures_program = Програма таймера з двома позначеними змінами
manifest_pictures_write = Що змінить запис, до самого запису
manifest_pictures_programPhone = Уся програма на телефоні
manifest_pictures_writePhone = Що змінить запис, на телефоні

## The help inside the page.

guide_pages_checklist = Чек-лист
guide_pages_trouble = Проблеми
guide_pages_words = Значення
guide_pages_steps = Перші кроки
guide_nav = Сторінки довідки

## What a new pilot is told.

firstSteps_1 = Зчитайте: натисніть «{ header_connect }», розбудіть таймер, піднесіть інфрачервону головку близько. Зчитування нічого не змінює й нічого не рухає.
firstSteps_2 = Запишіть: введіть нові значення, натисніть «Записати», перегляньте кожну відмінність. «Звірено» означає: таймер зчитано знову, і він містить те, що ви хочете.
firstSteps_3 = Летіть: угорі видно, яку пам’ять вибрано для наступного польоту і який у неї DT. Сторінці не потрібна мережа, і ніщо не покидає цей пристрій.

## The values of a program, with unit and range.

values_function_text = Етап польоту: у свій час кожен сервопривід переходить у своє положення. Щоб пропустити функцію, дайте їй положення попередньої.
values_function_range = Зазвичай старт, дев’ять функцій і DT.
values_time_text = Коли починається функція, від старту. Вводьте 12,5 або 2:05. Для F1B і F1E невідомо, від чого рахує таймер.
values_time_range = За посібниками. F1Q: від 0,1 до 99,9 с. F1B: від 0,01 до 9,99 с для функцій 1 і 2, далі від 0,1 до 99,9 с. F1E: невідомо.
values_after_text = Час від попередньої функції. Усі пізніші функції зсуваються разом із ним, DT — ні.
values_position_name = Положення
values_position_text = Де стоїть сервопривід. Кут одного кроку залежить від сервопривода й тяг: випробуйте на стенді.
values_position_range = Від 0 до 130 кроків.
values_motorStop_text = F1Q: коли зупиняється двигун, від старту. Жоден сервопривід при цьому не рухається.
values_motorStop_range = За посібником від 0,1 до 99,9 с, із кроком 0,1 с.
values_dt_text = Детермалізатор: коли він опускає модель, від старту. Червоний, якщо коротший за вашу межу.
values_dt_range = За посібником від 1 до 720 с. Понад 10:55 хв надіслати не можна.
values_idleThrottle_text = F1Q: імовірно, як швидко обертається двигун, поки натиснуто стартову кнопку.
values_idleThrottle_range = Сторінка припускає від 0 до 100. Одиниця невідома.
values_memory_text = У таймері кілька пам’ятей, у кожній одна програма. Наступний політ буде з вибраною. Щоб подивитися на іншу, сторінка вибирає її й повертається; якщо це перервано, сторінка каже, з якою може бути наступний політ.
values_memory_range = Зазвичай чотири, від M1 до M4. Старіші таймери мають п’ять.

## What a pilot checks before a flight.

checklist_lead = Позначте кожен пункт. Позначки діють на один політ і не зберігаються.
checklist_items_memory = Для наступного польоту вибрано правильну пам’ять.
checklist_items_dtTime = Час DT сказано вголос.
checklist_items_surfaces = Крило, стабілізатор і кермо напрямку сидять міцно й стоять як слід.
checklist_items_battery = Акумулятор заряджений, роз’єм вставлено до кінця.
checklist_items_dtSeen = Перевірено на власні очі: сервопривід переходить у положення DT.
checklist_items_radioDt = Радіо-DT випробувано, якщо він є.
checklist_items_switch = Стартову кнопку натиснуто п’ять разів, і щоразу вона відскакувала.
checklist_items_propeller = Пропелер закріплено міцно, він обертається вільно. Перед ним нікого немає.
checklist_known_now = Наступний політ: { $memory }, DT{"\u00a0"}{ $dt }, зчитано { $time }.
checklist_known_onceAt = За останнім зчитуванням { $time }: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_once = За останнім зчитуванням: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_not = Невідомо, що містить { $memory }. Зчитайте її, перш ніж летіти.
checklist_known_nothing = Жодного таймера не зчитано. З’єднайтеся, щоб побачити тут пам’ять для наступного польоту та її DT.
checklist_known_unwritten =
    { $count ->
        [one] { $count } зміна ще не в таймері.
        [few] { $count } зміни ще не в таймері.
       *[many] { $count } змін ще не в таймері.
    }
checklist_left =
    { $count ->
        [one] Лишився { $count } пункт
        [few] Лишилося { $count } пункти
       *[many] Лишилося { $count } пунктів
    }
checklist_done = Усе позначено. Гарного польоту.
checklist_again = Зняти всі позначки

## Problems as a pilot sees them, and what to do.

troubles_symptoms_noAnswer_title = Таймер не відповідає
troubles_symptoms_noAdapter_title = Сторінка не знаходить адаптера
troubles_symptoms_refused_title = Адаптер не відкривається
troubles_symptoms_wrongValues_title = Значення здаються неправильними
troubles_symptoms_wrongValues_steps_1 = Подивіться вгорі сторінки: яку пам’ять показано і яку вибрано для наступного польоту?
troubles_symptoms_wrongValues_steps_2 = Натисніть «{ program_read }».
troubles_symptoms_wrongValues_steps_3 = Часи спадають від рядка до рядка? Тоді сторінка питає, як їх читати.
troubles_symptoms_wrongValues_steps_4 = На F1B і F1E порівняйте часи з ручним програматором.
troubles_symptoms_cutOff_title = Запис перервано
troubles_symptoms_cutOff_steps_1 = Поки що не літайте цією моделлю. З’єднайтеся: сторінка зчитає таймер, а тоді запропонує завершити запис або записати старі значення назад.
troubles_symptoms_cutOff_steps_2 = Те, що таймер містив раніше, лежить у розділі «{ views_names_memories }», «{ backups_title }».
troubles_symptoms_noDt_title = DT не спрацьовує або спрацьовує невчасно
troubles_symptoms_noDt_steps_1 = Подивіться вгорі сторінки: там сказано, яку пам’ять вибрано для наступного польоту і який у неї DT. В іншої пам’яті інший DT.
troubles_symptoms_noDt_steps_2 = Чи щоразу відскакує стартова кнопка? Поки її натиснуто, послідовність не починається, і DT не спрацює.
troubles_symptoms_noDt_steps_3 = Чи заряджений акумулятор і чи вставлено роз’єм до кінця? Якщо таймер не працює, DT не спрацює.
troubles_symptoms_noDt_steps_4 = Надійно тримайте модель і натисніть рядок DT у розділі «{ views_names_bench }». Чи йде сервопривід у положення DT і чи відпускає те, що тримає?
troubles_symptoms_noDt_steps_5 = Зніміть пропелер і дайте таймеру відпрацювати до кінця. Не літайте, доки не побачите, що сервопривід рухається в момент DT.
troubles_symptoms_noMove_title = Сервопривід не рухається
troubles_symptoms_noMove_steps_1 = Тримайте модель і в розділі «{ views_names_bench }» натисніть рядок функції, на якій він має рухатися. Ніщо не рухається? Перевірте роз’єм і акумулятор. Там рухається, а в польоті ні? Тоді він має те саме положення, що й у попередній функції.
troubles_symptoms_noMove_steps_2 = Він іде не туди, куди каже таблиця? Можливо, деякі таймери зберігають положення лише для тієї функції, на якій стоять сервоприводи. Тоді сторінка пропонує рухати сервоприводи під час запису.
troubles_symptoms_noMove_steps_3 = Він гуде або зупиняється зарано? Можливо, його блокують тяги: спробуйте менший рух.
troubles_symptoms_noMotor_title = Двигун не запускається
troubles_symptoms_noMotor_steps_1 = Після польоту таймер блокує двигун. Щоб розблокувати його, тримайте модель, руки подалі від пропелера: він може запуститися. Тоді в розділі «{ views_names_bench }» тримайте кнопку «{ bench_unlock }».
troubles_symptoms_noMotor_steps_2 = Чи відскочила стартова кнопка? Поки її натиснуто, двигун працює лише на малому газі.
troubles_symptoms_noMotor_steps_3 = Чи досить пізно задано зупинку двигуна? Якщо задано 0,1 с, двигун зупиняється, щойно запустився.
troubles_symptoms_noLibrary_title = Моїх моделей і програм тут немає
troubles_symptoms_noLibrary_steps_1 = Очистьте поле пошуку, натисніть «Архів».
troubles_symptoms_noLibrary_steps_2 = Кожен браузер, профіль і адреса мають власну бібліотеку; приватне вікно її видаляє.
troubles_symptoms_noLibrary_steps_3 = На іншому пристрої або якщо її втрачено: «Імпорт» і файл вашого останнього експорту.

## What to do, step by step, when a timer cannot be reached.

help_title = Що робити
help_steps_programs = Закрийте інші вкладки й програми, які використовують адаптер, як-от Arduino IDE, PuTTY, програму 3D-принтера чи конфігуратор дрона.
help_steps_replug = Від’єднайте адаптер, зачекайте п’ять секунд, приєднайте знову. Якщо не допомогло, перезапустіть комп’ютер.
help_steps_cable = Приєднайте адаптер напряму, без розгалужувача, і спробуйте інший кабель. Багато USB-кабелів лише заряджають.
help_steps_windows = Windows: відкрийте Диспетчер пристроїв. Жовта позначка на адаптері означає, що бракує драйвера: під’єднайтеся до інтернету й запустіть Windows Update.
help_steps_mac = Mac: дозвольте аксесуар, коли Mac запитає. Стара macOS потребує драйвера виробника.
help_steps_linux = Linux може не дозволяти вам користуватися адаптером. Виконайте це, тоді вийдіть із системи й увійдіть знову.
help_steps_linux-container = Linux на Chromebook міг забрати адаптер. Вимкніть адаптер у налаштуваннях системи: Середовище розробки Linux, Керування USB-пристроями.
help_steps_android = На Android потрібен { android }. { restWorks }
help_steps_bluetooth = Bluetooth: створіть пару з адаптером у налаштуваннях системи (код 1234 або 0000), тримайте його ввімкненим і поряд, вимкніть Bluetooth на інших пристроях, які ним користуються.
help_steps_firefox-finds = Firefox не знаходить адаптерів Bluetooth, а встановлений із крамниці Ubuntu — взагалі жодних. Візьміть Chrome.
help_steps_firefox-reload = Firefox тримає адаптер, який дав збій. Завантажте цю сторінку знову. Те, що ви ввели, лишається.
help_steps_switch = { link_stages_steps_switch }
help_steps_near = { link_stages_steps_near }
help_steps_battery = Чи заряджений і приєднаний акумулятор таймера? Коли акумулятор розряджений, таймер стоїть у своєму положенні DT.
help_steps_restarts = Деякі адаптери перезапускаються щоразу, коли відкривають їхній порт (їх скидає DTR), і кілька секунд нічого не чують. Якщо ваш такий, задайте швидкість: «{ views_names_settings }», «{ ports_settings }». Тоді порт відкривається лише раз. Сама сторінка лишає DTR таким, як задає браузер.
help_steps_usual-settings = Відкрийте «{ views_names_settings }», «{ ports_settings }» і натисніть «{ ports_reset }»: тоді сторінка сама знайде швидкість.
help_steps_report = Якщо це станеться знову: «{ views_names_settings }», «Експерт», «{ views_names_line }», «{ line_copyReport }». Надішліть сюди:
help_steps_address = Відкрийте цю адресу у вкладці:
help_page = Усі кроки, для кожної системи

## For when the browser does not store, or give back, what it should.

keeping_title = Цей браузер тримає не все.
keeping_notKept = Введене, резервні копії та нотатка про перерваний запис існують лише доти, доки відкрита ця сторінка. Зробіть експорт бібліотеки. Тоді закрийте інші вкладки цієї сторінки або звільніть місце на цьому пристрої.
keeping_notKnown = Браузер не каже, чи лишиться те, що ви робите. Вважайте, що ні, і зробіть експорт бібліотеки.
keeping_oneTab = Користуйтеся лише однією вкладкою цієї сторінки.
keeping_emptied = Браузер видалив те, що тримав для цієї сторінки. Зробіть експорт того, що ще бачите.
keeping_export = Експорт бібліотеки…

## Stored data that cannot be read.

aside_title =
    { $count ->
        [one] { $count } елемент даних не вдалося прочитати. Його відкладено, не видалено.
        [few] { $count } елементи даних не вдалося прочитати. Їх відкладено, не видалено.
       *[many] { $count } елементів даних не вдалося прочитати. Їх відкладено, не видалено.
    }
aside_write = Серед цього є нотатка про перерваний запис: зчитайте таймер, перш ніж летіти.
aside_save = Зберегти у файл

## “2 models, 1 program”: only kinds that there are.

counted_models =
    { $count ->
        [one] { $count }{"\u00a0"}модель
        [few] { $count }{"\u00a0"}моделі
       *[many] { $count }{"\u00a0"}моделей
    }
counted_settings =
    { $count ->
        [one] { $count }{"\u00a0"}програма
        [few] { $count }{"\u00a0"}програми
       *[many] { $count }{"\u00a0"}програм
    }
counted_flights =
    { $count ->
        [one] { $count }{"\u00a0"}політ
        [few] { $count }{"\u00a0"}польоти
       *[many] { $count }{"\u00a0"}польотів
    }
counted_backups =
    { $count ->
        [one] { $count }{"\u00a0"}резервна копія
        [few] { $count }{"\u00a0"}резервні копії
       *[many] { $count }{"\u00a0"}резервних копій
    }

## What was deleted a moment ago.

removed = Видалено: { $what }.

## Deletes everything that this device keeps.

erase_open = Видалити все на цьому пристрої…
erase_lead = Це видаляє з цього браузера всі моделі, програми, польоти, резервні копії, незаписані зміни й вибрані на цій сторінці параметри. Відмінити це не можна. Вміст таймерів лишається.
erase_uncertain = Запис перервано, і невідомо, що містить той таймер. Без нотатки про той запис сторінка не зможе вас попередити: зчитайте той таймер, перш ніж летіти.
erase_start = Видалити все
erase_running = Видалення
erase_failed = Не все вдалося видалити. Закрийте інші вкладки цієї сторінки й спробуйте ще раз або видаліть її дані в налаштуваннях браузера.

## For a page that is shown inside another page.

framed_title = Sidus Timer працює лише у власній вкладці: інша сторінка могла б закрити те, що ви бачите про свій таймер.
framed_open = Відкрити Sidus Timer у власній вкладці

## What is known about the content of a timer, and what is not.

knowledge_title = Непевно
knowledge_uncertain = Невідомо, що містить { $memory }: { $values }.
knowledge_noFly = Не літайте, доки її не зчитано.
knowledge_since = Запис від { $time } перервано.
knowledge_thisMemory = поточна пам’ять
knowledge_memoryOf = { $memory } ({ $timer })
knowledge_timer_here = { $name } { $firmware }
knowledge_timer_simulated = симульований { $name } { $firmware }
knowledge_otherTimer_here = інший { $name } { $firmware }
knowledge_otherTimer_simulated = інший симульований { $name } { $firmware }
knowledge_motorStop = зупинка двигуна
knowledge_either = { $name } — { $before } або { $goal }
knowledge_list =
    { $more ->
        [one] { $named }; і ще { $more }{"\u00a0"}значення непевне
        [few] { $named }; і ще { $more }{"\u00a0"}значення непевні
       *[many] { $named }; і ще { $more }{"\u00a0"}значень непевні
    }
knowledge_and = { $first }; { $next }
knowledge_connect = З’єднати й зчитати
knowledge_forget = Забути це…
knowledge_forgetSure = Забувайте, лише якщо той таймер зчитано деінде або його у вас уже немає.
knowledge_forgetNow = Забути зараз
knowledge_verified = Як у таймері, звірено { $time }
knowledge_readAt = Як у таймері, зчитано { $time }
knowledge_lastReadAt = За останнім зчитуванням { $time }
knowledge_lastRead = За останнім зчитуванням
knowledge_ofSetting =
    { $changes ->
        [0] { $name }: збережено
        [one] { $name }: { $changes } зміну не збережено
        [few] { $name }: { $changes } зміни не збережено
       *[many] { $name }: { $changes } змін не збережено
    }
knowledge_changed = { $name }, змінено
knowledge_ofModel = { $name } ({ $model })
knowledge_made = Нова програма, ще в жодному таймері
knowledge_unknown = Невідомо, що містить { $memory }
knowledge_unfinished =
    { $count ->
        [one] { $count } поле ще не має значення
        [few] { $count } поля ще не мають значення
       *[many] { $count } полів ще не мають значення
    }
knowledge_hints_now = Позначені поля відрізняються від того, що містить таймер.
knowledge_hints_onceAt = Позначені поля відрізняються від останнього зчитування, { $time }.
knowledge_hints_once = Позначені поля відрізняються від останнього зчитування.
knowledge_marks_now = було { $value }
knowledge_marks_once = востаннє зчитано { $value }
knowledge_notCertain = , зараз непевно
knowledge_held_now = У таймері
knowledge_held_once = Востаннє зчитано

## Why a program of the library or from a link cannot be opened now.

obstacles_busy = Сторінка зчитує, записує або шукає таймер. Зачекайте, доки вона закінчить.
obstacles_following = Сервоприводи повторюють зміни. Спершу зупиніть це.
obstacles_not-fitting = { notFitting }

## Models and their saved programs.

library_unread = Браузер зараз не може прочитати бібліотеку. Закрийте інші вкладки цієї сторінки й спробуйте ще раз.
library_empty_title = Ще немає моделей
library_empty_lead = Модель містить свої програми, з назвами й нотатками. Вони лишаються тільки на цьому пристрої.
library_empty_hint = Створіть модель або зчитайте таймер і збережіть його програму.
library_search_label = Пошук програм
library_search_nothing = Жодна програма не містить усіх цих слів.
library_models_title = Моделі
library_models_all = Усі моделі
library_models_make = Нова модель…
library_models_settings =
    { $count ->
        [one] { $count } програма
        [few] { $count } програми
       *[many] { $count } програм
    }
library_models_archive = Архів ({ $count })
library_models_archived = в архіві
library_models_latest = Остання зміна
library_list_open = на екрані
library_model_timerClass = Клас
library_model_noClass = Не вказано
library_model_facts = Про цю модель
library_model_noSettings = Ще немає програм.
library_model_servos = Сервоприводи
library_model_servosUnknown = Спершу збережіть програму цієї моделі.
library_model_servoWay = кроки { $low }–{ $high }
library_model_archive = До архіву
library_model_unarchive = Взяти з архіву
library_model_remove = Видалити модель
library_model_withSettings =
    { $count ->
        [one] Разом із нею видаляється { $count }{"\u00a0"}програма. «Відмінити» поверне все.
        [few] Разом із нею видаляються { $count }{"\u00a0"}програми. «Відмінити» поверне все.
       *[many] Разом із нею видаляються { $count }{"\u00a0"}програм. «Відмінити» поверне все.
    }
library_setting_isOpen = На екрані: переглянути
library_setting_loadAgain =
    { $count ->
        [one] Відкрити знову: { $count } значення повернеться
        [few] Відкрити знову: { $count } значення повернуться
       *[many] Відкрити знову: { $count } значень повернуться
    }
library_setting_tags = Мітки, через кому
library_setting_from_typed = введено
library_setting_from_timer = зчитано з таймера
library_setting_from_simulated = зчитано із симульованого таймера
library_setting_from_backup = з резервної копії
library_setting_from_file = з файлу
library_setting_from_link = з посилання
library_setting_origin = { $source }, { $time }
library_setting_notShown = Не вдалося відкрити. Спробуйте ще раз.
library_setting_gone = Цього вже немає в бібліотеці.
library_save_open = Зберегти…
library_save_over = Зберегти поверх: { $program }
library_save_undo = Відмінити збереження: { $name }
library_save_crossing = Це значення моделі { $from }. Зберегти їх для моделі { $to }.
library_save_asNew = Зберегти як нову…
library_save_taken = Програма { $program } вже є. Введіть іншу назву або:
library_save_replace = Зберегти поверх неї. Її значення лишаються як попередня версія.
library_save_name =
    { $of ->
        [program] Назва програми
       *[model] Назва моделі
    }
library_save_namePlace = Наприклад: fly-off, штиль
library_save_notSavable = Поле не має значення. Спершу виправте його.
library_save_state =
    { $changes ->
        [0] { $name }: збережено
        [one] { $name }: { $changes } зміну не збережено
        [few] { $name }: { $changes } зміни не збережено
       *[many] { $name }: { $changes } змін не збережено
    }
library_nameNeeded = Потрібна назва.

## The log of the line.

line_empty = Немає що показати.
line_unused = На лінії ще нічого не було. Можна також завантажити запис обміну й відтворити його як таймер.
line_all = Усе
line_out = До таймера
line_in = Від таймера
line_damaged = Пошкоджене
line_request = { $name } · { $letters }
line_reply = { $name }, відповідь · { $letters }
line_echo = { $name }, луна · { $letters }
line_unknown = Невідома літера { $letter }
line_names_GETTIMERS = Зчитати часи
line_names_SETTIMERS = Записати часи
line_names_GETSERVOPOS = Зчитати положення
line_names_SETSERVO = Записати положення
line_names_MOVETOFUNC = Рухати сервоприводи
line_names_GETSWVER = Визначити таймер
line_names_UNLOCK = Розблокувати двигун
line_names_JUMP2 = Перехід
line_names_GETMEMORY = Яка пам’ять
line_names_SETMEMORY = Вибрати пам’ять
line_names_GETLOWRPM = Зчитати малий газ
line_names_SETLOWRPM = Записати малий газ
line_rejected_noise = Пошкоджено: шум
line_rejected_length = Пошкоджено: неможлива довжина
line_rejected_terminator = Пошкоджено: немає кінця там, де він має бути
line_rejected_checksum = Пошкоджено: неправильна контрольна сума
line_rejected_silence = Пошкоджено: обірвано
line_error_framing = Помилка лінії: кадрування
line_error_parity = Помилка лінії: парність
line_error_break = Помилка лінії: обрив
line_error_overrun = Помилка лінії: переповнення, байти втрачено
line_error_other = Помилка лінії іншого виду
line_position = { $slot }, { $servo }: крок { $steps }
line_motorStop = зупинка двигуна { $time }
line_reserved = резерв { $time }
line_functions = функції { $times }
line_identity = { $name }, прошивка { $firmware }, { $functions } і DT, { $memories }, { $servos }
line_memories =
    { $count ->
        [one] { $count } пам’ять
        [few] { $count } пам’яті
       *[many] { $count } пам’ятей
    }
line_memoryUnsaid = Не каже, яка саме.
line_idleThrottle = { $value }, одиниця невідома
line_idleThrottleUnsaid = Не дає значення.
line_acknowledged = Підтверджено.
line_unreadable_wrong-length = Вміст довший або коротший, ніж має бути.
line_unreadable_unknown-command = Невідомо, що це означає.
line_unreadable_unexpected-reply = Це відповідь на інший запит.
line_unreadable_bad-identity = Те, що тут сказано про таймер, не може бути правильним.
line_unreadable_identity-needed = Це можна прочитати, коли таймер скаже, що він таке.
line_unreadable_out-of-range = Одне зі значень не може бути правильним.
line_unreadable_not-an-integer = { line_unreadable_out-of-range }
line_unreadable_wrong-count = { line_unreadable_out-of-range }
line_unreadable_wrong-type = { line_unreadable_out-of-range }
line_unreadable_unknown-word = Вміст не можна прочитати.
line_unreadable_bad-capture = { line_unreadable_unknown-word }
line_unreadable_bad-file = { line_unreadable_unknown-word }
line_unreadable_bad-link = { line_unreadable_unknown-word }
line_unreadable_newer-version = { line_unreadable_unknown-word }
line_unreadable_too-large = { line_unreadable_unknown-word }
line_unreadable_duplicate = { line_unreadable_unknown-word }
line_goOn = Далі
line_came =
    { $number ->
        [one] Пауза. Відтоді { $number } рядок.
        [few] Пауза. Відтоді { $number } рядки.
       *[many] Пауза. Відтоді { $number } рядків.
    }
line_clear = Очистити
line_unidentified = невідомо
line_load = Завантажити…
line_filter = Показати
line_searchHint = назва або hex
line_counts_out = { $count } до таймера
line_counts_in = { $count } від таймера
line_counts_damaged = { $count } пошкоджено
line_counts_errors =
    { $count ->
        [one] { $count } помилка лінії
        [few] { $count } помилки лінії
       *[many] { $count } помилок лінії
    }
line_recording =
    { $entries ->
        [one] { $name }: запис обміну, { $entries } рядок.
        [few] { $name }: запис обміну, { $entries } рядки.
       *[many] { $name }: запис обміну, { $entries } рядків.
    }
line_replay = Відтворити як таймер
line_cannotReplay = Відтворити не можна: таймер ніде не каже, що він таке.
line_back = Назад до живої лінії
line_noRecordingAt = Рядок { $line }: очікувався час у секундах, > або <, і байти в hex.
line_noRecording = Цей файл не є записом обміну.
line_send_title = Надіслати кадр вручну
line_send_lead = Довжину й контрольну суму додає сторінка.
line_send_bytes = Літера й дані, у hex
line_send_faults_hex = Введіть дві шістнадцяткові цифри на кожен байт, від 0 до 9 або від A до F.
line_send_faults_too-long = Кадр несе щонайбільше 252 байти.
line_send_preview = Вийде так
line_send_send = Надіслати…
line_send_confirmTitle = Надіслати цей кадр таймеру?
line_send_danger = Сервоприводи можуть зрушити, пропелер може запуститися, а вміст таймера може змінитися. Після цього таймер буде зчитано знову.
line_send_confirm = Так, надіслати раз
line_send_sending = Надсилання
line_send_answered = Відповідь:
line_send_unanswered = Відповідь не надійшла. Те, чого вимагав кадр, усе одно могло статися.
line_copyReport = Копіювати звіт

## From the ports to a timer that answers.

link_portNames_ftdi = Адаптер FTDI
link_portNames_cp210x = Адаптер CP210x (Silicon Labs)
link_portNames_ch340 = Адаптер CH340 (WCH)
link_portNames_pl2303 = Адаптер PL2303 (Prolific)
link_portNames_bluetooth = Bluetooth
link_portNames_usb = USB-адаптер
link_portNames_other = Послідовний порт
link_stages_choosing = Виберіть адаптер таймера
link_stages_openingLong_title = Адаптер довго відкривається
link_stages_openingLong_advice = Bluetooth: увімкніть адаптер, поряд. Кабель: від’єднайте його і приєднайте знову.
link_stages_asking = Запит на { $rate } бод.
link_stages_noAnswer = Немає відповіді { $seconds } с. Сторінка питає далі й сама продовжить.
link_stages_open = Адаптер відкрито
link_stages_steps_switch = Розбудіть таймер: коротко натисніть його кнопку
link_stages_steps_near = Тримайте інфрачервону головку ближче ніж 20 см, не на сонці
link_stages_steps_other = Таймер на іншому адаптері?
link_refused = Сторінка пробує ще 15 секунд. Адаптер може тримати інша програма.
link_heard_title = Щось чути, але жоден таймер не відповідає.
link_heard_advice = Розбудіть таймер і тримайте головку ближче, не на сонці, або виберіть інший адаптер.
link_slow_title = Таймер відповідає, але заповільно.
link_slow_advice = Його байти приходять по одному на { $rate } бод, із такими паузами, що жодна відповідь не встигає надійти цілою. Сторінка не може його зчитати. Спробуйте інший адаптер або кабель замість Bluetooth.
link_itSaid = Надійшло: { $bytes } («{ $text }»).
link_trySelectBare = Спробувати без правильної контрольної суми
link_lost_title = З’єднання з адаптером втрачено.
link_lost_advice = Приєднайте його або піднесіть ближче: сторінка сама продовжить. Те, що ви ввели, лишається.
link_status_off = Не з’єднано
link_status_opening = З’єднання
link_status_searching = Пошук таймера
link_status_away = З’єднання втрачено
link_status_closing = Роз’єднання

## The known ports, and how they are opened.

ports_title = Відомі адаптери
ports_forget = Забути
ports_settings = Параметри порту
ports_settingsHint = Лише для особливого адаптера. Сторінка сама знаходить швидкість.
ports_rate = Швидкість
ports_findRate = Знайти
ports_baud = { $rate } бод
ports_parity = Парність
ports_parities_none = Немає
ports_parities_even = Парна
ports_parities_odd = Непарна
ports_stopBits = Стопові біти
ports_dtr = DTR
ports_rts = RTS
ports_signals_leave = Як задає браузер
ports_signals_on = Увімкнено
ports_signals_off = Вимкнено
ports_reset = Звичайні параметри

## What is known about the connected timer. Its numbers are in the report.

aboutTimer_title = Про цей таймер
aboutTimer_damage = Пошкодження на лінії
aboutTimer_crowd = У промені може бути інший таймер або програматор. Відтоді мають збігатися два зчитування.
aboutTimer_found = Що він робив інакше
aboutTimer_nothingFound = Поки нічого: він виконав усе, про що питали, звичайним способом.
aboutTimer_quirkNames_timers-reply-66 = Він відповідає літерою іншої команди.
aboutTimer_quirkNames_unlock-reply-6a = { aboutTimer_quirkNames_timers-reply-66 }
aboutTimer_quirkNames_memory-unknown = Він не каже, яка пам’ять поточна.
aboutTimer_quirkNames_memory-impossible = { aboutTimer_quirkNames_memory-unknown }
aboutTimer_quirkNames_bare-checksum = Про малий газ він відповідає не як звичайно.
aboutTimer_quirkNames_times-big-endian = Його часи спадають. Якби два байти кожного часу поміняти місцями, вони б зростали.
aboutTimer_quirkNames_servo-first = Під час запису положення він чекає сервопривід перед функцією.
aboutTimer_quirkNames_servo-unanswered = Він не відповів під час запису положення.
aboutTimer_quirkNames_times-rounded = Він округлює часи.
aboutTimer_quirkNames_memories-from-one = Він рахує свої пам’яті від 1.
aboutTimer_quirkNames_positions-unchanged = Він підтвердив положення, але не зберіг їх.
aboutTimer_quirkNames_echo = Адаптер надсилає назад те, що отримує.
aboutTimer_quirkNames_idle-throttle-unanswered = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_identity-unusual = Те, що він каже про себе, містить невідомі байти.
aboutTimer_quirkNames_idle-throttle-malformed = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_replies-alike = Його відповіді на деякі запити пошкоджені, щоразу однаково.
aboutTimer_assumed = Відомі відмінності
aboutTimer_assumedHint = Запам’ятовано для цього адаптера й цього виду таймера.
aboutTimer_forget = Забути відомі відмінності
aboutTimer_assumptions_bigEndianTimes = Два байти кожного часу поміняно місцями
aboutTimer_assumptions_servoFirst = { aboutTimer_quirkNames_servo-first }
aboutTimer_assumptions_memoriesFromOne = { aboutTimer_quirkNames_memories-from-one }
aboutTimer_assumptions_bareChecksumRequests = «Вибрати пам’ять» і «Записати малий газ» надсилаються без правильної контрольної суми
aboutTimer_assumptions_positionsNeedMove = Положення зберігаються лише для функції, на якій стоять сервоприводи

## Which memory flies next, and what is known about the others.

nextFlight_badge = наступний політ
nextFlight_onScreen = Це { $memory }.
nextFlight_named = { $memory }, наступний політ
nextFlight_other = Наступний політ: { $memory }.
nextFlight_last = { $memory } була поточною, коли таймер відповідав востаннє. Наступний політ буде з нею, якщо ніщо інше цього не змінило.
nextFlight_original = Коли ви з’єдналися, це була { $original }.
nextFlight_originalUnknown = Невідомо, яка це була, коли ви з’єдналися.
nextFlight_unknown = Невідомо, яку пам’ять вибрано для наступного польоту.
nextFlight_asked = Востаннє вибрано { $memory }.
nextFlight_back = Назад до { $original }
nextFlight_leaving_title = Перш ніж роз’єднати
nextFlight_leaving_back = Назад до { $original } і роз’єднати
nextFlight_leaving_failed = Таймер не повернувся до { $original }. Він ще з’єднаний.

## The last reading of a memory that is not current.

look_read = { $memory }, зчитано { $time }
look_notRead = { $memory } не зчитано
look_either = Або це
look_or = або це
look_lead = Лише для перегляду. Наступний політ: { $current }.
look_edit = Редагувати { $memory }
look_look = Подивитися { $memory }
look_hint = Це вибирає { $memory }, зчитує її й повертається до { $current }.
look_fly = Вибрати { $memory } для польоту
look_show = Показати { $memory }

## Jobs over several memories, and the backups.

memories_copy = Копіювати { $from } до { $to }
memories_restore = Відновити резервну копію
memories_restoreAll = Відновити всі { $count }…
memories_plans_screen =
    { $keepsThrottle ->
        [true] { $to } міститиме часи й положення з екрана. Спершу буде зроблено резервну копію того, що { $to } містить зараз. Малий газ лишається як є.
       *[false] { $to } міститиме часи й положення з екрана. Спершу буде зроблено резервну копію того, що { $to } містить зараз.
    }
memories_plans_copy = { $to } міститиме часи й положення з { $from }, щойно зчитані. Спершу буде зроблено резервну копію того, що { $to } містить зараз.
memories_plans_restore = Це записує резервну копію від { $time } сюди: { $names }. Спершу буде зроблено резервну копію того, що там є зараз.
memories_atEnd = Наприкінці для наступного польоту знову буде вибрана { $current }.
memories_refused = Сюди не можна записати нічого ({ $memory }): цих значень не може надіслати жодне програмне забезпечення.
memories_untouched = Сюди нічого не записано: { $memory }.
memories_stopped = Те, що ще не було записано, лишилося як було.

## All memories of a timer at a glance.

overview_readAll = Зчитати всі з копією
overview_copyTo = Копіювати до…
overview_compareWith = Порівняти з { $memory }
overview_readAt = зчитано { $time }
overview_notCertain = Непевно: запис сюди перервано. Показано, як було до того запису.
overview_edited = Показано й копіюється те, що містить таймер, без ваших змін.
overview_same = Вони містять те саме.
overview_differs =
    { $count ->
        [one] { $count } значення відрізняється.
        [few] { $count } значення відрізняються.
       *[many] { $count } значень відрізняються.
    }

## How the timer writes its times: the question that no reading can answer.

byteOrder_title = Часи цього таймера спадають від рядка до рядка.
byteOrder_advice = Вони б зростали, якби два байти кожного часу поміняти місцями. Порівняйте з тим, що знаєте про таймер, і виберіть, перш ніж записувати.
byteOrder_keep = Вони правильні, як показано
byteOrder_exchange = Поміняти й зчитати ще раз

## Why there is no connection.

connection_unsupported_title = { unsupportedHere_title }
connection_unsupported_advice = { unsupportedHere_advice }
connection_insecure_title = Браузер не дозволяє тут послідовних портів.
connection_insecure_advice = { restWorks }
connection_policy_title = Сервер цієї сторінки забороняє послідовні порти.
connection_policy_advice = { restWorks }
connection_nothing-chosen_title = Адаптера не вибрано.
connection_nothing-chosen_advice = Натисніть «{ header_connect }» і виберіть адаптер. Якщо його немає у списку, допоможуть кроки нижче.
connection_not-allowed_title = { connection_insecure_title }
connection_not-allowed_advice = Дозвольте послідовні порти для цієї сторінки в налаштуваннях браузера, тоді знову натисніть «{ header_connect }».
connection_busy_title = Адаптер не відкривається.
connection_busy_advice = Найчастіше його тримає інша програма або вкладка. Закрийте її, тоді знову натисніть «{ header_connect }».
connection_bad-settings_title = Адаптер не приймає цих параметрів.
connection_bad-settings_advice = { help_steps_usual-settings }
connection_unplugged_title = Адаптер недоступний.
connection_unplugged_advice = Від’єднайте його, приєднайте знову й натисніть «{ header_connect }». Те, що ви ввели, лишається.
connection_bad-reply_title = { link_heard_title }
connection_bad-reply_advice = { link_heard_advice }
connection_lost_title = { connection_unplugged_title }
connection_lost_advice = { connection_unplugged_advice }

## Why a job with the timer has ended.

timer_no-answer_title = Таймер не відповів.
timer_no-answer_advice = Коротко натисніть кнопку таймера, тримайте головку ближче ніж 20 см і спробуйте ще раз. Те, що ви ввели, лишається.
timer_bad-reply_title = Відповідь таймера не може бути правильною.
timer_bad-reply_advice = Спробуйте ще раз. Якщо це станеться знову: «{ views_names_settings }», «Експерт», «{ views_names_line }», «{ line_copyReport }».
timer_unstable_title = Лінія надто зашумлена, щоб їй довіряти.
timer_unstable_advice = Тримайте інфрачервону головку ближче, не на сонці, і спробуйте ще раз.
timer_crowded_title = У промені може бути більше ніж один таймер.
timer_crowded_advice = Тримайте інші таймери й програматори подалі та зчитайте ще раз.
timer_other-memory_title = Поточна пам’ять — не та, що на екрані.
timer_other-memory_advice = Зчитайте ще раз, перш ніж записувати.
timer_memory-unknown_title = Цей таймер не каже, яка пам’ять поточна.
timer_memory-unknown_advice = Тому сторінка не може подивитися іншу пам’ять і повернутися. Поточну можна зчитувати й записувати.
timer_memory-left_title = Можливо, для наступного польоту вибрана вже інша пам’ять.
timer_memory-left_advice = Сторінка не змогла повернутися до тієї, що була поточною. З’єднайтеся знову й виберіть правильну пам’ять для наступного польоту, перш ніж летіти.
timer_other-timer_title = Це не той таймер, що відповідав раніше.
timer_other-timer_advice = Сторінка зчитує його. Подивіться, що він містить, перш ніж записувати.
timer_stale_title = Таймер містить не те, що було показано.
timer_stale_advice = Нічого не записано. Подивіться, що запис змінив би тепер.
timer_changed_title = Таймер містить інші значення, ніж раніше.
timer_changed_advice = Його вміст змінило щось інше, або це інший таймер. Ваші зміни не втрачено: подивіться на відмінності, перш ніж записувати.
timer_stood-still_title = Під час роботи ця сторінка завмерла.
timer_stood-still_advice = Більше нічого не надіслано: тепер там може бути інший таймер. Зчитайте ще раз.
timer_too-slow_title = Цей таймер відповідає заповільно.
timer_too-slow_advice = Його відповіді тривають понад 3 секунди, тож сторінка не може сказати, яка до якого запитання. Більше нічого не надіслано. Спробуйте інший адаптер або кабель замість Bluetooth.
timer_undecided_title = { byteOrder_title }
timer_undecided_advice = { byteOrder_advice }
timer_serious_title = Перевірка знайшла щось серйозне.
timer_serious_advice = { timer_stale_advice }
timer_busy_title = Щось на цій сторінці або на цьому комп’ютері використовує адаптер.
timer_busy_advice = Нічого не надіслано. Роз’єднайте й з’єднайтеся знову. Те, що ви ввели, лишається.
timer_port-lost_title = { link_lost_title }
timer_port-lost_advice = { link_lost_advice }
timer_aborted_title = Зупинено.
timer_aborted_advice = Зчитайте ще раз, щоб побачити, що містить таймер.
timer_closed_title = Роз’єднано.
timer_closed_advice = Щоб продовжити, натисніть «{ header_connect }». Те, що ви ввели, лишається.

## Replies that are no noise, which is random.

alike_title = Кожна відповідь на { $request } пошкоджена однаково.
alike_advice = Це не шум: таймер або його адаптер формує ці відповіді невідомим способом. Увімкніть «Експерт» у параметрах, відкрийте «{ views_names_line }» і натисніть «{ line_copyReport }». Надішліть звіт розробникам сторінки (github.com/sidus-timer/sidus-timer/issues).
alike_part = Лише для перегляду: { $values }. Усе інше невідоме.

## Messages that are not about errors.

notes_back_title = Ваші зміни повернулися.
notes_back_advice = Порівняйте їх із тим, що містить таймер, тоді запишіть або відмініть їх.
notes_back-uncertain_title = { notes_back_title }
notes_back-uncertain_advice = Невідомо, чи їх записано. З’єднайтеся з таймером і зчитайте його, перш ніж летіти.
notes_moved_title = { timer_changed_title }
notes_moved_advice = { timer_changed_advice }
notes_timer-moved_title = { timer_changed_title }
notes_timer-moved_advice = { timer_changed_advice }
notes_kept_title = Ваші зміни лишаються на цьому пристрої.
notes_kept_advice = Вони не підходять до того, що зчитано зараз. Вони повернуться, коли ви знову зчитаєте ту пам’ять; їх видно й на початковому екрані.
notes_other-kind_title = Тепер там таймер іншого виду.
notes_other-kind_advice = { timer_other-timer_advice }
notes_write-completed_title = Перерваний запис завершено.
notes_write-completed_advice = Таймер зчитано знову, він містить усе, що треба було записати.
notes_nothing-written_title = { write_refused }
notes_nothing-written_advice = {""}
notes_not-backed-up_title = { write_unkept_title }
notes_not-backed-up_advice = { keeping_notKept }
notes_select-unanswered_title = Таймер не відповів, коли вибирали пам’ять.
notes_select-unanswered_advice = На інші запити він відповідає. Спробуйте ще раз або надішліть запит без правильної контрольної суми.
notes_backed-up_title = Усі пам’яті зчитано, і для кожної є резервна копія.
notes_backed-up_advice = {""}
notes_strays_title = { timer_crowded_title }
notes_strays_advice = { timer_crowded_advice }
notes_made-laid_title = Таблиця показує вашу програму, а не те, що містить таймер.
notes_made-laid_advice = Нічого не записано. Відмінності позначено. «Відмінити» показує, що містить таймер.
notes_unexpected_title = На цій сторінці щось пішло не так.
notes_unexpected_advice = Більше нічого не надіслано. Завантажте сторінку знову. Те, що ви ввели, лишається.

## The flight of the program, and what the servos of the model move.

preview_title = Перегляд польоту
preview_guessed = Не в масштабі.
preview_nameServos = Назвати сервоприводи…
preview_play = Відтворити
preview_speed = Швидкість
preview_time = Час польоту
preview_launch = Старт
preview_at = { $what } на { $time }
preview_sketch = Модель збоку, її кермо напрямку згори
preview_motor_true = Набір висоти, двигун працює
preview_motor_false = Планування, двигун зупинено
preview_flies = У польоті
preview_comesDown = DT: модель опускається
preview_duties_rudder = Кермо напрямку
preview_duties_tailplane = Стабілізатор
preview_duties_wing = Крило
preview_duties_release = Диск або нитка DT
preview_duties_other = Щось інше
preview_duties_none = Не використано
preview_naming_lead = Що рухає кожен сервопривід і між якими кроками. Вгору й униз — це про задню кромку.
preview_naming_duty = { $servo } рухає
preview_naming_name = Назва того, що рухає { $servo }
preview_naming_low = { $servo }, один край у кроках
preview_naming_high = { $servo }, другий край у кроках
preview_naming_from = від
preview_naming_to = до
preview_naming_sense = { $servo }, що дає більше кроків
preview_naming_otherSense_false = більше кроків: угору
preview_naming_otherSense_true = більше кроків: униз
preview_naming_rudderSense_false = більше кроків: праворуч
preview_naming_rudderSense_true = більше кроків: ліворуч

## The sheet of a program.

print_paper = Папір
print_what = На аркуші
print_parts_lines = Рядки для нотаток
print_parts_code = QR-код
print_nothing = Виберіть програми з бібліотеки або відкрийте одну.
print_choose = Програми на цьому аркуші: { $chosen }
print_clear = Прибрати всі
print_simulated = симульований таймер
print_warnings = Перегляньте це перед польотом
print_notes = Нотатки
print_codeHint = Камера телефона відкриває цю програму, без її нотатки.
print_unfinished =
    { $count ->
        [one] { $count } поле ще не має значення: надруковано останнє
        [few] { $count } поля ще не мають значення: надруковано останні
       *[many] { $count } полів ще не мають значення: надруковано останні
    }
print_printed = Надруковано { $date }

## The model in the strip.

recognition_which = Яка модель?
recognition_change = Модель { $model }: вкажіть, яка це модель

## A memory with the pilot's name for it: M2 “fly-off”.

memoryNames_named = { $memory } «{ $name }»

## What an earlier job left behind on a timer.

recovery_title = Раніший запис перервано.
recovery_when = Запис ({ $memory }) почався { $time }.
recovery_nothing =
    { $missing ->
        [one] Таймер містить те саме, що й раніше: нічого не записано, бракує { $missing } зміни.
        [few] Таймер містить те саме, що й раніше: нічого не записано, бракує { $missing } змін.
       *[many] Таймер містить те саме, що й раніше: нічого не записано, бракує { $missing } змін.
    }
recovery_part =
    { $missing ->
        [one] Таймер містить із того запису: { $values }; { $missing } значення ще таке, як раніше.
        [few] Таймер містить із того запису: { $values }; { $missing } значення ще такі, як раніше.
       *[many] Таймер містить із того запису: { $values }; { $missing } значень ще такі, як раніше.
    }
recovery_foreign =
    { $count ->
        [one] { $count } значення в таймері ані старе, ані з того запису. Це інший таймер, чи вміст таймера змінило щось інше?
        [few] { $count } значення в таймері ані старі, ані з того запису. Це інший таймер, чи вміст таймера змінило щось інше?
       *[many] { $count } значень у таймері ані старі, ані з того запису. Це інший таймер, чи вміст таймера змінило щось інше?
    }
recovery_sure = Сторінка не розрізняє таймерів одного виду. Продовжуйте, лише якщо це таймер того запису.
recovery_finish = Завершити запис…
recovery_goBack = Записати старі значення назад…
recovery_leave = Лишити як є
recovery_otherTimer = Це інший таймер
recovery_sameTimer = Це той самий таймер: показати, що треба було записати
recovery_compare = Порівняти
recovery_before = Раніше
recovery_elsewhere = Запис у { $memory } таймера такого виду перервано. Зчитайте { $memory }, щоб побачити, що вона містить.
recovery_left = Роботу з пам’ятями перервано. Тепер наступний політ: { $current }. До того: { $original }.
recovery_mayFly = Можливо, для наступного польоту вибрана { $memory }: її вибір перервано.
recovery_mayNotFly = Роботу з пам’ятями перервано. Можливо, для наступного польоту вибрана інша пам’ять, не { $original }.
recovery_unknownMemory = невідома пам’ять

## The backups.

backups_title = Резервні копії
backups_empty = Перед кожним записом сторінка лишає тут копію того, що містить таймер.
backups_reasons_write = перед записом
backups_reasons_memories = усі пам’яті

## How the page looks.

theme_title = Кольори
theme_names_system = Системні
theme_names_light = Світлі
theme_names_dark = Темні
theme_names_sun = Сонце

## The settings of the page.

settings_look = Вигляд
settings_expert = Експерт: показати лінію
settings_expertHint = Лінія показує кожен байт між цією сторінкою і таймером. Стенд пропонує неописаний перехід.
settings_kept = Що тримає цей пристрій

## A saved program as a link and a QR code, and back.

share_offer_lead = Посилання містить усю програму. На сервер нічого не надсилається.
share_offer_link = Посилання
share_offer_copy = Копіювати посилання
share_offer_scan = Наведіть камеру іншого пристрою на цей код або надішліть посилання.
share_offer_qr = QR-код «{ $name }»
share_offer_cut = Кінець нотатки не вміщається в QR-код. Посилання містить усю нотатку.
share_offer_tooLong = Задовго для QR-коду. Надішліть посилання.
share_received_title = Програма з посилання
share_received_lead = Поки що сторінка лише показує її. На пристрої нічого не лишено, у таймер нічого не записано.
share_received_known = У бібліотеці ці значення вже є: { $name }.
share_received_modelChoice = Лишити під
share_received_newModel = Нова модель «{ $name }»
share_received_keep = Лишити в бібліотеці
share_received_discard = Не лишати
share_received_unwritten = Те, що ви ввели, лишається: його поверне «Відмінити» або початковий екран.
share_damaged_title = Це посилання не можна прочитати.
share_damaged_bad = Воно обрізане, пошкоджене або не з цієї сторінки. Попросіть його ще раз.
share_paste_title = Вставити посилання…
share_paste_lead = Камера телефона сама відкриває QR-код. Сюди можна вставити посилання.
share_paste_show = Показати
share_paste_notLink = Це не посилання на програму.

## A DT for trimming that is about to be flown. The page asks before the pilot disconnects, and at a contest round.

shortDt_held = { $memory }: DT { $dt }.
shortDt_heldHere = DT { $dt }.
shortDt_ask =
    { $remembered ->
        [true] Повернути до { $back }?
       *[false] Задати { $back }?
    }
shortDt_putBack =
    { $remembered ->
        [true] Повернути DT до { $back }…
       *[false] Задати DT { $back }…
    }
shortDt_disconnect = Роз’єднати так: { $memory }, DT{"\u00a0"}{ $dt }
shortDt_disconnectHere = Роз’єднати так: DT{"\u00a0"}{ $dt }
shortDt_blocked = Щось із введеного ще не можна записати. Виправте це, перш ніж повертати DT.
shortDt_settings_limit = DT короткий, якщо менший за
shortDt_settings_hint = Коротший DT червоний, і сторінка питає, перш ніж ви роз’єднаєте. Якщо тут 0 с, вона не питає ніколи.

## The start, before anything was read.

start_title = Налаштуйте таймер Sidus
start_lead = Зчитайте, що він містить, змініть, запишіть і побачте, що це звірено. Ніщо не покидає цей пристрій.
start_adapter = Приєднайте адаптер
start_firefox = Firefox спершу питає дозволу, а про порт — щоразу, коли завантажено цю сторінку.
start_android = Телефон з’єднується через Bluetooth; для кабелю потрібні Android { firstVersions_androidCable } і Chrome { firstVersions_android }.
start_readyOffline = Готово без мережі
start_install = Установити
start_picture_example = Приклад: F1Q
start_picture_kept = Від { $time }
start_models_title = Мої моделі
start_models_none = Тримайте тут програми кожної моделі, з нотатками.
start_models_programs =
    { $count ->
        [one] { $count } програма
        [few] { $count } програми
       *[many] { $count } програм
    }
start_models_library = Відкрити бібліотеку
start_programs_title = Не завершено
start_programs_made = { $timer }, нова
start_programs_changesOf = { $timer }, зміни
start_programs_sure = Видалити назавжди?
start_simulatedTitle = Таймера з собою немає?
start_simulatedLead = Симульований відповідає як справжній, байт за байтом.
start_simulated = Спробувати симульований { $name }
start_backups =
    { $count ->
        [one] { $count } резервна копія, зроблена перед записом. Остання: { $last }.
        [few] { $count } резервні копії, зроблені перед записом. Остання: { $last }.
       *[many] { $count } резервних копій, зроблених перед записом. Остання: { $last }.
    }

## The dialog that makes a program without a timer.

newProgram_title = Нова програма…
newProgram_timerClass = Клас
newProgram_functions = Функції, без старту й DT
newProgram_servos = Сервоприводи
newProgram_from = Почати з
newProgram_beginnings_usual = Звичайні часи, сервоприводи посередині
newProgram_beginnings_nothing = Усі часи й положення 0
newProgram_caution = Положення вашої моделі тут невідомі. Задайте кожне, перш ніж записувати.
newProgram_make = Створити програму

## The picture of a program over time.

timeline_title = Шкала часу
timeline_compareBefore = до повторення змін
timeline_picture = Положення сервоприводів у часі
timeline_description = { $servos } і { $functions } у часі, DT на { $dt }. Усі значення є в таблиці.
timeline_descriptionMotor = { $servos } і { $functions } у часі, DT на { $dt }, зупинка двигуна на { $motorStop }. Усі значення є в таблиці.
timeline_functions =
    { $count ->
        [one] { $count } функція
        [few] { $count } функції
       *[many] { $count } функцій
    }
timeline_servos =
    { $count ->
        [one] { $count } сервопривід
        [few] { $count } сервоприводи
       *[many] { $count } сервоприводів
    }
timeline_keysToEdit = Стрілки ведуть від позначки до позначки й від сервопривода до сервопривода, плюс і мінус змінюють масштаб, 0 показує все. Enter веде до ручок: їх рухають стрілки, Escape повертає.
timeline_ask = Наведіть або торкніться, щоб прочитати
timeline_finer = Точніше
timeline_steps =
    { $position ->
        [one] { $position } крок
        [few] { $position } кроки
       *[many] { $position } кроків
    }
timeline_stepsUnit = кроки
timeline_notKnown = Невідомо: часи спадають
timeline_tools = Вигляд
timeline_zoomIn = Збільшити
timeline_zoomOut = Зменшити
timeline_fit = Показати все
timeline_passedOver = { $slot } пропускається, бо в той самий час настає { $next }.
timeline_goesBack = { $next } настає раніше, ніж { $slot }. Невідомо, що робить таймер у затіненій частині.

## A new version of the page.

update_ready = Готова нова версія.
update_waits = Вона запуститься, коли ви роз’єднаєте і ніщо не буде відкрите чи незбережене.
update_take = Узяти зараз
update_news = Що нового

## The version of this page.

aboutPage_title = Ця сторінка
aboutPage_version = Sidus Timer { $version }.
aboutPage_offline = Уся сторінка на цьому пристрої: вона працює без мережі.
aboutPage_notOffline = Сторінки ще немає на цьому пристрої: відкрийте її раз із мережею.
aboutPage_licences = Ліцензії

## The views of the page and the links between them.

views_title = Розділи
views_names_program = Програма
views_names_memories = Пам’ять
views_names_bench = Стенд
views_names_library = Бібліотека
views_names_line = Лінія
views_names_settings = Параметри
views_names_print = Друк
views_names_help = Довідка
views_print = Друк…
views_share = Поділитися…
views_noTimer_memories = З’єднайтеся з таймером, щоб побачити його пам’яті. Резервні копії нижче.
views_noTimer_bench = З’єднайтеся з таймером, щоб рухати його сервоприводи.

## The strip above every view: the timer, its memory, DT, motor stop, and what is known.

strip_panel = Пам’ять та інше
strip_tried = { $count } випробувано
strip_notCertain = непевно
strip_asRead = зчитано раніше
strip_notValid = недійсне
strip_ofSetting =
    { $changes ->
        [0] збережено
       *[other] { $changes } не збережено
    }
strip_made = не в таймері

## The list of commands.

palette_title = Команди
palette_search = Введіть, що хочете зробити
palette_nothing = Команди з такою назвою немає, або зараз її не можна виконати.
palette_ctrl = Ctrl+{ $key }

## In place of a part of the page that is being loaded.

parts_coming = Завантаження
parts_failed = Частину цієї сторінки не вдалося завантажити.
parts_again = Ще раз

## Which model it is.

whichModel_recognition_same = Це { $model }, вміст такий, як був { $when }.
whichModel_recognition_like =
    { $count ->
        [one] Схоже на { $model }, { $count } значення відрізняється. Це { $model }?
        [few] Схоже на { $model }, { $count } значення відрізняються. Це { $model }?
       *[many] Схоже на { $model }, { $count } значень відрізняються. Це { $model }?
    }
whichModel_recognition_several = Це може бути { $models }. Яка це модель?
whichModel_or = { $names } або { $last }
whichModel_others = ще { $count }
whichModel_recognition_unknown = Цей таймер тут невідомий. Яка це модель?
whichModel_recognition_yes = Так, { $model }
whichModel_recognition_choose = Вибрати…
whichModel_recognition_ok = OK
whichModel_recognition_dialog_title = Яка це модель?
whichModel_recognition_dialog_lead = Таймер не знає своєї моделі. Сторінка порівнює його вміст із тим, що востаннє бачила в кожній моделі.
whichModel_recognition_dialog_said = Ви сказали, що це { $model }.
whichModel_recognition_dialog_moreMemories = Зчитайте й інші пам’яті: за ними моделі, можливо, вдасться розрізнити.
whichModel_recognition_dialog_none = Такої моделі цього класу немає.
whichModel_recognition_dialog_newModel = Нова модель
whichModel_recognition_dialog_keep = Лишити як нову модель
whichModel_memoryNames_label = Назва { $memory }
whichModel_memoryNames_give = Назвати
whichModel_crossing_title = Це значення моделі { $from }, але цей таймер схожий на таймер моделі { $to }.
whichModel_crossing_advice = Зі значеннями іншої моделі ви можете втратити цю. Подивіться на модель перед собою.
whichModel_crossing_confirm = Записати значення моделі { $from } в таймер моделі { $to }.
whichModel_crossing_memoryOf = { $memory } ({ $model })

## A write, from the difference to the verdict.

write_title = Запис у таймер
write_lead = Ось що змінюється тут: { $memory }. Усе інше лишається як є.
write_target = Записати в
write_nothing = Відмінностей немає. Таймер буде зчитано повторно й порівняно.
write_field = Значення
write_from = У таймері
write_to = Буде
write_wasRead = Зчитано раніше
write_moved_model_title = Цей таймер тепер, схоже, належить іншій моделі.
write_moved_model_advice = Нічого не записано. Подивіться на назви моделей.
write_moved_edits_title = Програма змінилася, відколи це було показано.
write_unkept_title = Цей пристрій не зміг зберегти резервну копію того, що таймер містить зараз.
write_unkept_advice = Ця пам’ять ще така, як була. Продовжити без резервної копії?
write_sideBySide = Значення: { $names }
write_withoutCopy = Продовжити без резервної копії
write_safety = Пропелер знято або модель тримають, і таймер не взведено.
write_acknowledge = Прочитано, усе одно хочу це записати.
write_stillToTick = Ще позначити: { $ticks }.
write_ticks_model = інша модель
write_ticks_warnings = попередження
write_ticks_safety = пропелер
write_move_why = Схоже, цей таймер зберігає положення лише для функції, на якій стоять його сервоприводи. Якщо сервоприводи не рухатимуться, цих положень він, імовірно, не збереже.
write_move_label = Переводити сервоприводи до кожної функції, перш ніж записати її положення.
write_move_hint = Надійно тримайте модель. Сервоприводам ніщо не має заважати.
write_move_notHeld_title = Таймер підтвердив положення, але не зберіг їх.
write_move_notHeld_advice = Імовірно, цей таймер зберігає їх лише для функції, на якій стоять його сервоприводи. Запишіть ще раз і дозвольте сервоприводам переходити до кожної функції.
write_move_again = Записати ще раз…
write_start =
    { $count ->
        [0] Зчитати повторно й порівняти
        [one] Записати { $count } зміну
        [few] Записати { $count } зміни
       *[many] Записати { $count } змін
    }
write_stages_read = Зчитування
write_stages_write = Запис
write_stages_verify = Повторне зчитування
write_stages_repair = Виправлення
write_stopping = Зупинка після цього запиту
write_stoppingBack = Зупинка: спершу назад до попередньої пам’яті
write_verified_title = Звірено.
write_verified_advice = Таймер зчитано повторно, він містить те, що було показано.
write_verdict = { $memory }: звірено { $time }
write_asItIs = як є
write_insteadOf = замість { $value }
write_wanted = Треба записати
write_readBack = Зчитано повторно
write_differs_title = Таймер прийняв не всі значення.
write_differs_advice = Таймер зчитано повторно. Тут він містить інші значення:
write_unknown_title = Непевно, що містить таймер.
write_unknown_advice = Таймер не вдалося повторно зчитати повністю. Зчитайте ще раз, тоді запишіть те, що ще відрізняється. Ваші зміни не втрачено.
write_cut = Запис ({ $memory }) перервано.
write_strayed_title = Під час запису поточною стала { $memory }.
write_strayed_advice = Частина значень тепер може бути в { $memory }. Зчитайте її й перегляньте всю, перш ніж летіти з нею.
write_refused = Нічого не записано.
write_status_differs = відрізняється
write_status_unknown = невідомо
write_putBack = змінив сам таймер, повернуто старе

## What the parts of the page that are loaded first say.

name = Sidus Timer
classNames_Q = F1Q
classNames_B = F1B
classNames_E = F1E
unknownClass = Клас { $letter }
memoryName = M{ $number }
servoName = S{ $number }
slotName =
    { $kind ->
        [start] Старт
        [dt] DT
       *[function] Функція { $slot }
    }
within_slot =
    { $kind ->
        [start] старт
        [dt] DT
       *[function] функція { $slot }
    }
within_idleThrottle = малий газ
slotShort =
    { $kind ->
        [start] Старт
        [dt] DT
       *[function] { $slot }
    }
about = { $name }:
previous = Попередній
next = Наступний
pause = Пауза
less = { $what }: менше
moreOf = { $what }: більше
seconds = { $time }{" "}с
times_minutes = { $minutes }{" "}хв
times_minutesSeconds = { $minutes }{" "}хв { $seconds }{" "}с
times_units_s = с
times_units_min = хв
times_figure = { $text } { $unit }
times_asSeconds = { $seconds }{" "}с, { $clock }
times_meaning = Що означає введене: { $field }
header_firmware = прошивка { $firmware }
header_simulated = симулятор
header_connect = З’єднати
header_choosePort = Інший адаптер
header_closeProgram = Закрити програму
header_disconnect = Роз’єднати
header_stop = Стоп
program_tableCaption = Час і положення сервоприводів кожної функції
program_slot = Функція
program_time = Час
program_memory = Пам’ять
program_memoryUnknown = Цей таймер не каже, яка пам’ять поточна, тому невідомо, яку вибрано для наступного польоту.
program_memoryOpen = Невідомо, яку пам’ять вибрано для наступного польоту. Виберіть одну або зчитайте ще раз.
program_dt = DT
program_motorStop = Зупинка двигуна
program_motor = Двигун
program_idleThrottle = Малий газ
program_throttle = Малий газ
program_idleThrottleUnit = одиниця невідома
program_reserved = резерв { $time }
program_timeOf = { $slot }, час
program_motorStopTime = Час зупинки двигуна
program_positionOf = { $slot }, { $servo }
program_shortDt = Короткий DT
program_changes =
    { $count ->
        [one] { $count } зміна
        [few] { $count } зміни
       *[many] { $count } змін
    }
program_undoAll = Відмінити все
program_read = Зчитати ще раз
program_connectAndWrite = З’єднати й записати…
program_write =
    { $count ->
        [0] Записати…
        [one] Записати { $count } зміну…
        [few] Записати { $count } зміни…
       *[many] Записати { $count } змін…
    }
program_picture = Графік
program_table = Таблиця
program_blocked = Записати ще не можна нічого. { $field }: { $why }
program_findings = Перевірка
program_noFindings = Нічого незвичного.
program_absolute = Показано від старту. Невідомо, чи цей таймер рахує від старту, чи від попередньої функції.
program_severity_error = Не можна записати
program_severity_serious = Серйозно
program_severity_warning = Незвично
program_reading = Зчитування таймера
program_selecting = Зміна пам’яті
otherTab_holdsSince = Sidus Timer відкрито в іншій вкладці, з { $since }.
otherTab_holds = Sidus Timer відкрито в іншій вкладці.
otherTab_takeOver = Працювати тут
otherTab_busy = Інша вкладка працює з таймером. Щойно це скінчиться, сторінка відкриється тут.
otherTab_gone = Інша вкладка не відповідає. Закрийте її, тоді завантажте цю сторінку знову.
disturbed = Відповідей бракує або вони пошкоджені: чи таймер не спить, чи інфрачервона головка близько й не на сонці? Це скінчиться щонайпізніше за { $seconds } с.
cancel = Скасувати
close = Закрити
copy = Копіювати
copied = Скопійовано.
copyByHand = Браузер не дозволяє цій сторінці копіювати. Скопіюйте звідси.
dismiss = Сховати
done = Готово
undo = Відмінити
open = Відкрити
save = Зберегти
delete = Видалити
notNow = Не зараз
label_language = Мова
label_name = Назва
label_note = Нотатка
label_model = Модель
label_search = Пошук
noModel = Без моделі
more = І ще { $count }.
showMore = Показати ще { $count }
of = { $button }: { $name }
notFitting = Це не підходить до з’єднаного таймера. Щоб відкрити, роз’єднайте.
notKept = Цей браузер цього не зберіг: воно зникне, коли ви закриєте сторінку.

## The walk through the open questions of docs/protocol.md with a real timer.

settle_title = З’ясувати на вашому таймері
settle_lead = Не все відомо про те, як говорять ці таймери. За п’ятнадцять хвилин ваш з’ясує, що відкрито. Після кожної проби старе значення повертається. Майте під рукою ручний програматор.
settle_safe = Пропелер знято або двигун від’єднано, і таймер не взведено.
settle_danger = Зараз щось може зрушити. Чи знято пропелер або від’єднано двигун? Подивіться ще раз.
settle_blocked = Спершу владнайте те, про що йдеться у смузі вгорі, і залишіть випробуване або поверніть попереднє.
settle_readIt = Зчитати таймер
settle_which = Що показує ручний програматор?
settle_tryHint = Переведіть сервоприводи кнопками й зачекайте, доки вони зупиняться. Тоді випробуйте положення: його буде змінено, а старе повернуто за кілька секунд. Стежте за сервоприводами.
settle_tryIt = Випробувати положення
settle_moved = Старе положення повернуто: це показало зчитування. Чи рухався якийсь сервопривід, коли випробовували нове?
settle_ask = Запитати з чотирма нулями
settle_unknown = Не знаю
settle_send = Надіслати файл цією формою
settle_names_order = Молодший байт часу йде першим
settle_names_unit = Часи в сотих частках секунди
settle_names_count = Часи рахуються від старту
settle_names_memories = Перша пам’ять має номер 0
settle_names_zeros = Досить чотирьох нулів
settle_names_layout = Функція йде перед сервоприводом
settle_names_stores = Положення зберігаються за будь-якої функції
settle_names_moves = Записане положення рухає свій сервопривід
settle_names_unlock = Літера відповіді на UNLOCK
settle_names_delay = Звичайний час відповіді
settle_names_reserved = Резервний час, зчитаний
settle_yes = Так
settle_no = Ні
settle_unnumbered = Номера не дано
settle_there = Лише там, де стоять сервоприводи
settle_delay = { $ms } мс
settle_open = Не з’ясовано
