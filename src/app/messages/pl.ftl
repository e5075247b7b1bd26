### Wszystko, co mówi strona, po polsku. Nazwy zdań są te same co w en.ftl.
###
### Translated without a pilot of that language; corrections welcome (docs/translating.md).

## Moving servos and motor from the page.

bench_slots = Przestaw na
bench_elsewhere = Serwa i silnik działają z pamięcią następnego lotu: { $memory }. Pokaż { $memory }, aby nimi poruszać.
bench_trim = Regulacja: { $slot }
bench_at = Serwa w położeniu: { $slot }
bench_atNone = Nie wiadomo, gdzie stoją serwa.
bench_moveMaybe = Brak odpowiedzi. Serwa mogły się mimo to poruszyć. Spójrz na model.
bench_unlocked = Silnik jest odblokowany. Śmigło może ruszyć.
bench_unlockMaybe = Brak odpowiedzi. Silnik może być mimo to odblokowany. Trzymaj się z dala od śmigła.
bench_jumped = Timer potwierdził skok.
bench_here = tu stoją serwa
bench_waits = Czeka na „Wgraj”.
bench_bring = Przestaw serwa: { $slot }
bench_follow = Serwa podążają za pozycjami
bench_followHint = Najpierw strona odczytuje timer i zachowuje kopię zapasową. Potem każda pozycja, którą zmienisz w wierszu, przy którym stoją serwa, jest od razu zapamiętywana w timerze, a jej serwo się porusza.
bench_followingNow = Serwa podążają: pozycja, którą zmienisz w wierszu, przy którym stoją, jest od razu zapamiętywana w timerze.
bench_stopFollowing = Zakończ podążanie
bench_ended_over = Serwa już nie podążają.
bench_ended_memory = Serwa już nie podążają: bieżąca jest albo może być inna pamięć.
bench_ended_strayed = Podczas podążania serw bieżąca stała się inna pamięć. Mogła przyjąć część pozycji: obejrzyj ją całą, zanim z nią polecisz.
bench_ended_unlike = Serwa już nie podążają: timer nie zrobił tego, co potwierdził.
bench_ended_failed = Serwa już nie podążają: timer nie odpowiedział.
bench_notTaken = { $field }: w timerze jest { $held }, a nie { $wanted }.
bench_beside =
    { $more ->
        [0] Poza tym zmieniło się: { $named }.
        [one] Poza tym zmieniło się: { $named }; i jeszcze { $more } wartość.
        [few] Poza tym zmieniło się: { $named }; i jeszcze { $more } wartości.
       *[many] Poza tym zmieniło się: { $named }; i jeszcze { $more } wartości.
    }
bench_triedHere =
    { $more ->
        [0] Wypróbowano: { $named }.
        [one] Wypróbowano: { $named }; i jeszcze { $more } pozycję.
        [few] Wypróbowano: { $named }; i jeszcze { $more } pozycje.
       *[many] Wypróbowano: { $named }; i jeszcze { $more } pozycji.
    }
bench_triedAndWaiting =
    { $waiting ->
        [0] wypróbowane w timerze: { $tried }
        [one] wypróbowane w timerze: { $tried }, na „Wgraj” czeka { $waiting }
        [few] wypróbowane w timerze: { $tried }, na „Wgraj” czekają { $waiting }
       *[many] wypróbowane w timerze: { $tried }, na „Wgraj” czeka { $waiting }
    }
bench_triedIn = Wypróbowano pozycje. Pamięć: { $memory }.
bench_decide = Zachować wypróbowane pozycje czy przywrócić to, co timer zawierał przedtem?
bench_keep = Zachowaj
bench_putBack = Przywróć…
bench_unlock = Przytrzymaj: UNLOCK
bench_unlockHold = Trzymaj dalej
bench_unlockHint = Śmigło może ruszyć. Trzymaj model, ręce trzymaj z dala od śmigła, potem naciśnij i przytrzymaj.
bench_experimental = Eksperymentalne
bench_jumpHint = Skok do funkcji, która następuje po przedwczesnym DT. Dokładne działanie nie jest opisane: serwa mogą się poruszyć.
bench_jump = Skok…
bench_jumpSure = Wyślij skok teraz

## The log of flights.

flights_title = Loty
flights_empty_title = Nie ma jeszcze żadnego lotu.
flights_empty_advice = Odczytaj timer albo wgraj do niego program, potem naciśnij „{ flights_flying_button }”.
flights_failed = Przeglądarka nie może teraz odczytać biblioteki. Zamknij inne karty tej strony i spróbuj ponownie.
flights_flying_button = Zapisz lot
flights_flying_purpose = Zapisuje lot z tym, co zawiera timer.
flights_flying_logged = Lot zapisany { $time }
flights_flying_fillIn = Uzupełnij
flights_flying_again = Taki sam lot
flights_row_round = Kolejka { $round }
flights_row_wind = { $wind } m/s
flights_row_temperature = { $degrees } °C
flights_row_noResult = bez wyniku
flights_row_changed = zmiana: { $values }
flights_row_otherTimer = inny timer
flights_totals_flights =
    { $count ->
        [one] { $count } lot
        [few] { $count } loty
       *[many] { $count } lotów
    }
flights_totals_best = najlepszy { $time }
flights_totals_average = średnio { $time }
flights_filter_of = Loty: { $name }
flights_filter_clear = Pokaż wszystkie
flights_form_title = Lot
flights_form_result = Wynik
flights_form_resultHint = Sekundy albo minuty, na przykład 2:58.
flights_form_readAs = { $time }, { $seconds } s
flights_form_propose = Wpisz: { $facts }
flights_form_full = Pełny lot, 180 s
flights_form_round = Kolejka
flights_form_flyOff = Dogrywka
flights_form_wind = Wiatr
flights_form_windUnit = m/s
flights_form_temperature = Temperatura
flights_form_temperatureUnit = °C
flights_form_when = Data, miejsce, model
flights_form_date = Data i godzina
flights_form_noOffset = Strefa czasowa lotniska nie jest znana: to czas tego urządzenia.
flights_form_place = Miejsce
flights_form_flown = Nastawy w locie
flights_form_open = Otwórz program tego lotu
flights_form_unreadable_not-a-number = To nie jest liczba.
flights_form_unreadable_not-a-time = To nie jest czas: wpisz sekundy, na przykład 178, albo minuty, na przykład 2:58.
flights_form_unreadable_too-fine = { unreadable_too-fine }
flights_form_range = Od { $min } do { $max } { $unit }.
flights_form_shortDt = DT w tym locie: { $dt }.
flights_score_open = Karta wyników
flights_score_maximum = Maksimum każdej kolejki
flights_score_none = Bez maksimum każdy wynik liczy się w całości.
flights_score_maximumOf = Maksimum: { $round }
flights_score_counted = Zaliczone (s)
flights_score_notCounted = niezaliczony
flights_score_count = Zalicz ten
flights_score_noRound = brak kolejki
flights_score_total = Suma
flights_score_copy = Kopiuj jako tekst
flights_csv_save = Zapisz jako tabelę (CSV)
flights_csv_columns_date = Data
flights_csv_columns_time = Godzina
flights_csv_columns_zone = Strefa czasowa
flights_csv_columns_place = Miejsce
flights_csv_columns_model = Model
flights_csv_columns_setting = Program
flights_csv_columns_timerClass = Klasa timera
flights_csv_columns_memory = Pamięć
flights_csv_columns_dt = DT (s)
flights_csv_columns_motorStop = Stop silnika (s)
flights_csv_columns_wind = Wiatr (m/s)
flights_csv_columns_temperature = Temperatura (°C)
flights_csv_columns_round = Kolejka
flights_csv_columns_result = Wynik (s)
flights_csv_columns_maximum = Maksimum (s)
flights_csv_columns_note = Notatka
flights_section_all = Wszystkie loty

## Values that are unusual, or cannot be written.

findings_time-not-whole = { unreadable_not-a-whole-number }
findings_time-out-of-range = Musi być od { $min } do { $max }.
findings_position-not-whole = { unreadable_not-a-whole-number }
findings_position-out-of-range = Musi być od { $min } do { $max }.
findings_throttle-not-whole = { unreadable_not-a-whole-number }
findings_throttle-out-of-range = Musi być od { $min } do { $max }.
findings_position-as-read = Odczytano { $value }, więcej niż ostatni krok, { $max }. Zostaje tak, dopóki tego nie zmienisz.
findings_time-falls = To wypada przed funkcją powyżej ({ $previous }).
findings_time-repeats = Ten sam czas co w funkcji powyżej, { $previous }.
findings_position-never-reached = Ten sam czas co w funkcji powyżej, { $previous }. Pozycje funkcji powyżej nigdy nie zostaną osiągnięte.
findings_motor-stop-after-dt = Silnik staje dopiero po DT ({ $dt }): model opada z pracującym silnikiem.
findings_motor-run-long = Silnik pracuje dłużej niż { $limit }, a to limit dla F1Q.
findings_time-outside-manual = Instrukcja dopuszcza od { $min } do { $max }.
findings_time-too-fine = Instrukcja podaje krok { $step }: timer może zaokrąglić.
findings_dt-short = Krócej niż { $limit }.
findings_dt-moves-nothing = Przy DT nie porusza się żadne serwo: timer nie sprowadza modelu na ziemię.
findings_throttle-unusual = Więcej niż { $limit } jest nietypowe. Jednostka nie jest znana.
findings_class-unknown = Klasa „{ $timerClass }” nie jest znana: jej reguł nie sprawdzono.

## Why a text in a field is no value.

unreadable_empty = Puste: wpisz wartość.
unreadable_not-a-time = To nie jest czas: wpisz sekundy, na przykład 12,5, albo minuty, na przykład 2:05.
unreadable_too-fine = Dokładniej niż do jednej setnej sekundy.
unreadable_not-a-whole-number = To musi być liczba całkowita.
unreadable_ambiguous = Można to zrozumieć na kilka sposobów: wybierz jeden.

## For a page that cannot reach a timer here.

restWorks = Wszystko poza połączeniem działa i tutaj.

## What an Android phone needs.

firstVersions_android = 148
firstVersions_androidBluetooth = 138
firstVersions_lastBluetoothOnly = 147
firstVersions_androidCable = 17
android = Chrome { firstVersions_android } lub nowszy ({ firstVersions_androidBluetooth } do { firstVersions_lastBluetoothOnly } tylko przez Bluetooth); kabel wymaga Androida { firstVersions_androidCable }

## For every browser about which nothing more is known. docs/connection.md names the first versions.

unsupportedHere_title = Ta przeglądarka nie może połączyć się z timerem.
unsupportedHere_advice = Na komputerze użyj aktualnej wersji Chrome, Edge, Opera lub Firefox; na telefonie Chrome na Androidzie. { restWorks }

## Replaces the sentence above where the browser's name tells more.

unsupported_brave_title = Brave połączy się z timerem tylko wtedy, gdy na to zezwolisz.
unsupported_brave_advice = Otwórz brave://flags/#brave-web-serial-api, ustaw Enabled i naciśnij Relaunch. { restWorks }
unsupported_ios_title = Na iPhonie i iPadzie żadna przeglądarka nie może połączyć się z timerem.
unsupported_ios_advice = Użyj komputera albo Chrome na telefonie z Androidem. { restWorks }
unsupported_android_title = { unsupportedHere_title }
unsupported_android_advice = Na Androidzie potrzebny jest { android }. { restWorks }

## What a saved program held before it was saved over.

versions_title = Wcześniejsze wersje
versions_until = Do{"\u00a0"}{ $when }
versions_changed =
    { $more ->
        [0] potem { $change }
       *[other] potem { $change } i jeszcze{"\u00a0"}{ $more }
    }
versions_otherLayout = potem wartości dla innego timera
versions_same = Zapisany program ma teraz te same wartości.
versions_goBack = Wróć do tej wersji

## Two programs side by side.

compare_title = Porównaj
compare_open = Porównaj…
compare_second = z programem
compare_screen = Na ekranie
compare_timer = Timer, { $memory }
compare_groups_now = Teraz
compare_groups_settings = Zapisane programy
compare_setting = { $model } · { $name }
compare_backup = { $memory } · { $when }
compare_backupOf = { $model } · { $memory } · { $when }
compare_nothing = Na tym urządzeniu nie ma innego programu tej klasy i o tym układzie.
compare_take = Weź
compare_takeOf = Weź { $value } dla pola: { $field }
compare_takeHint = „Weź” kopiuje wartość do programu na ekranie.

## How a backup differs from what its timer holds.

modelBackups_same = jak w timerze ({ $when })
modelBackups_differs =
    { $count ->
        [one] { $count } wartość inna niż w timerze ({ $when })
        [few] { $count } wartości inne niż w timerze ({ $when })
       *[many] { $count } wartości innych niż w timerze ({ $when })
    }
modelBackups_now = teraz

## Undo, redo, and edits of many fields at once.

edits_redoButton = Ponów
edits_undo = Cofnij: { $step }
edits_redo = Ponów: { $step }
edits_steps_change = zmiana ({ $what })
edits_steps_shift = przesunięcie o { $by } ({ $what } i dalej)
edits_steps_step-servo = { $what } o { $steps }
edits_steps_step-servo-from = { $what } o { $steps } ({ $from } i dalej)
edits_steps_paste = wklejenie ({ $count })
edits_steps_fill = wypełnienie w dół ({ $count })
edits_steps_revert-all = przywrócenie wszystkiego
edits_steps_open = otwarcie ({ $what })
edits_steps_keep-tried = zachowanie wypróbowanych pozycji
edits_opened = „{ $name }”
edits_openedUnnamed = inny program
edits_refused_start = Start nie ma czasu do zmiany.
edits_refused_later-out-of-range = Późniejsza funkcja wypadłaby poza zakres od { $min } do { $max }.
edits_refused_unreadable = Przeszkadza tekst, który nie jest wartością. Najpierw go popraw.
edits_refused_interval-disagrees = Ten odstęp nie zgadza się z czasami obu wierszy.
edits_refused_no-place = W programie nie ma takiego miejsca.
edits_refused_twice = To miejsce występuje dwa razy, z różnymi wartościami.
edits_refused_too-large = Tabela jest za duża: odczytywanych jest najwyżej { $cells } komórek. Resztę pominięto.
edits_beforeLaunch = To byłoby przed startem.
edits_nothingDone = Nic nie zmieniono.
edits_cells =
    { $count ->
        [one] { $count } wartość
        [few] { $count } wartości
       *[many] { $count } wartości
    }
edits_change = { $field }: { $from } → { $to }
edits_field_putBack = Przywróć: { $field }
edits_field_putBackTo = Przywróć { $figure }: { $field }
edits_sheet_title = Klawisze: { $field }
edits_sheet_erase = Usuń ostatnią cyfrę
edits_sheet_putBack = Przywróć
edits_sheet_selectRange = Zaznacz zakres
edits_sheet_goTo = Przejdź: { $name }
edits_table_explain = Co znaczą wartości
edits_table_interval = Odstęp
edits_table_countedFrom = od { $row }
edits_table_switch = Czas lub odstęp
edits_table_intervalOf = { $slot }, odstęp
edits_table_range_title = Zaznaczony zakres
edits_table_range_pick = Teraz dotknij innej komórki.
edits_table_range_size = { $cells }, { $columns }
edits_table_range_functions =
    { $count ->
        [one] { $count } funkcja
        [few] { $count } funkcje
       *[many] { $count } funkcji
    }
edits_table_range_rows =
    { $count ->
        [one] { $count } wiersz
        [few] { $count } wiersze
       *[many] { $count } wierszy
    }
edits_table_range_columns =
    { $count ->
        [one] { $count } kolumna
        [few] { $count } kolumny
       *[many] { $count } kolumn
    }
edits_table_range_paste = Wklej…
edits_table_range_fillDown = Wypełnij w dół
edits_table_range_clipboardClosed = Nie ma do wklejenia nic, co ta strona może zobaczyć. Dotknij pierwszego pola i wklej tam.
edits_table_tools = Narzędzia: { $name }
edits_stepServo_title = Wszystkie pozycje: { $servo }
edits_stepServo_now = Teraz { $position }
edits_stepServo_nowRange = Teraz od { $lowest } do { $highest }
edits_stepServo_by = O ile kroków
edits_stepServo_step = Przestaw
edits_stepServo_which = Które
edits_stepServo_all = Wszystkie funkcje
edits_stepServo_from = Od: { $slot }
edits_stepServo_stops =
    { $count ->
        [one] { $steps }: { $what } zatrzyma się na { $at }.
        [few] { $steps }: { $what } zatrzymają się na { $at }.
       *[many] { $steps }: { $what } zatrzymają się na { $at }.
    }
edits_shift_open = Przesuń…
edits_shift_from =
    { $isLast ->
        [true] { $row }
       *[false] { $row } i wszystko dalej
    }
edits_shift_by = O ile sekund
edits_shift_earlier = Wcześniej
edits_shift_later = Później
edits_shift_moveDt = Przesuń też DT
edits_shift_function = funkcja { $number }
edits_shift_functionRange = funkcje { $first } do { $last }
edits_shift_functions = funkcje { $numbers }
edits_shift_moved =
    { $later ->
        [true] Przesunięto o { $time }{" "}s później
       *[false] Przesunięto o { $time }{" "}s wcześniej
    }
edits_pasting_asks = Te nazwy nie są znane. Wybierz, co znaczą:
edits_pasting_choose = Wybierz
edits_pasting_leaveOut = Pomiń
edits_pasting_table = Co gdzie trafi
edits_pasting_lead =
    { $count ->
        [0] To niczego nie zmieni.
        [one] To zmieni { $count } wartość.
        [few] To zmieni { $count } wartości.
       *[many] To zmieni { $count } wartości.
    }
edits_pasting_reading = { $field }: „{ $text }” rozumiane jako { $time }.
edits_pasting_problems = Tego nie można wkleić:
edits_pasting_place = Wiersz { $row }, kolumna { $column } skopiowanego tekstu
edits_pasting_problem = { $place }: { $reason }
edits_pasting_problemOf = { $place }, „{ $text }”: { $reason }
edits_pasting_apply = Wklej
edits_presets_title = Gotowe czasy DT
edits_presets_use = DT { $time }
edits_presets_refused = Wpisz czasy, na przykład 20 s lub 2:30, do 10:55 min, najwyżej 24.
edits_fix = Ustaw { $value }
edits_fixOf = Ustaw { $value }: { $field }

## The library as files: export, import, and the reminder to export.

files_export_all = Eksportuj wszystko…
files_export_one = Eksportuj…
files_export_downloaded = Plik „{ $name }” trafia do pobranych: { $what }. Sprawdź, czy tam jest.
files_export_without = brak: { $kind }
files_export_kinds_models = modele
files_export_kinds_settings = programy
files_export_kinds_flights = loty
files_export_partly = Plik „{ $name }” nie jest kompletny. Zawiera: { $what }. Przeglądarka nie może teraz odczytać: { $missing }. Zamknij inne karty tej strony i eksportuj ponownie.
files_export_and = { $first } i { $next }
files_export_tooLarge = Biblioteka jest za duża na jeden plik. Eksportuj jej modele pojedynczo.
files_export_failed = Nie udało się utworzyć pliku. Wczytaj stronę ponownie i spróbuj jeszcze raz.
files_import_button = Importuj…
files_import_title = Import: { $name }
files_import_lead = Zapisano { $date }. Zawiera: { $what }.
files_import_leadNothing = Zapisano { $date }. Nic nie zawiera.
files_import_ignored =
    { $count ->
        [one] { $count } wpis pochodzi z nowszej wersji tej strony i zostanie pominięty.
        [few] { $count } wpisy pochodzą z nowszej wersji tej strony i zostaną pominięte.
       *[many] { $count } wpisów pochodzi z nowszej wersji tej strony i zostanie pominiętych.
    }
files_import_nothing = Masz już to wszystko.
files_import_differs = Co się różni
files_import_ways_newer = Weź nowsze
files_import_ways_both = Zachowaj oba
files_import_itself = sam model
files_import_flightOf = lot z dnia { $day }
files_import_wayText_newer = To, co tutaj jest nowsze lub ma tę samą datę, zostaje.
files_import_wayText_both = Zostają oba. Ten z pliku dostaje numer po nazwie.
files_import_unknownModel = Model, którego tu nie ma
files_import_group_fresh = Nowe: { $what }
files_import_group_same = Takie same: { $what }
files_import_group_fileNewer = Nowsze w pliku: { $what }
files_import_group_deviceNewer = Nie nowsze w pliku: { $what }
files_import_group_fileName = { $file } (tutaj: { $here })
files_import_take =
    { $count ->
        [0] Nie ma czego importować
       *[other] Importuj { $count }
    }
files_import_allStays = Nic w pliku nie jest nowsze. Wybierz „{ files_import_ways_both }”, aby mimo to importować.
files_import_done = Zaimportowano z „{ $name }”: { $what }.
files_import_undo = Cofnij import
files_import_undone = Import cofnięto. Późniejsze zmiany zostają.
files_refused_title = Nie można importować: { $name }
files_refused_nothing = Niczego nie zaimportowano.
files_refused_again = Wyeksportuj plik ponownie albo poproś nadawcę o nowy.
files_refused_fault = Wiersz{"\u00a0"}{ $line }: jest { $found }.
files_refused_faultIn = Wiersz{"\u00a0"}{ $line }, { $place }: jest { $found }.
files_refused_wanted = Oczekiwano:
files_refused_place_entry =
    { $kind ->
        [models] Model „{ $name }”
        [settings] Program „{ $name }”
       *[flights] Lot „{ $name }”
    }
files_refused_place_unnamed =
    { $kind ->
        [models] Model { $number } w pliku
        [settings] Program { $number } w pliku
       *[flights] Lot { $number } w pliku
    }
files_refused_place_function = funkcja { $number }
files_refused_damaged = Plik jest uszkodzony albo niekompletny.
files_refused_files_too-large = Plik jest za duży jak na bibliotekę.
files_refused_files_gone = Nie udało się odczytać pliku. Wybierz go ponownie.
files_refused_files_several = Importuj po jednym pliku.
files_refused_format = To nie jest plik biblioteki Sidus Timer.
files_refused_newer = Utworzyła go nowsza wersja tej strony. Wczytaj stronę ponownie, gdy będziesz online.
files_reminder =
    { $changes ->
        [one] { $changes } zmiana w bibliotece jest tylko na tym urządzeniu. Jeśli je stracisz, odzyskasz ją tylko z pliku.
        [few] { $changes } zmiany w bibliotece są tylko na tym urządzeniu. Jeśli je stracisz, odzyskasz je tylko z pliku.
       *[many] { $changes } zmian w bibliotece jest tylko na tym urządzeniu. Jeśli je stracisz, odzyskasz je tylko z pliku.
    }

## For the time before the other sentences are loaded.

first_failed = Strona nie jest kompletna. Czy jest sieć?
first_again = Wczytaj ponownie

## What a system shows of the installed page: public/manifest.webmanifest has the same in English.

manifest_description = Ustawia timery Sidus F1Q, F1B i F1E modeli swobodnie latających: odczytuje zawartość timera, przyjmuje twoje zmiany, wgrywa je, odczytuje kontrolnie i porównuje. Przechowuje twoje modele i programy na tym urządzeniu. Działa bez sieci.
manifest_connect = Połącz timer
manifest_connectShort = Połącz
manifest_connectWhat = Strona początkowa z przyciskiem „Połącz”
manifest_library = Biblioteka
manifest_libraryWhat = Modele i ich programy
manifest_simulated = Symulowany timer
manifest_simulatedWhat = Strona początkowa z symulowanymi timerami
manifest_pictures_program = Program timera z dwiema wyróżnionymi zmianami
manifest_pictures_write = Co zmieni wgranie, pokazane przed wgraniem
manifest_pictures_programPhone = Cały program na telefonie
manifest_pictures_writePhone = Co zmieni wgranie, na telefonie

## The help inside the page.

guide_pages_checklist = Checklista
guide_pages_trouble = Problemy
guide_pages_words = Wartości
guide_pages_steps = Pierwsze kroki
guide_nav = Strony pomocy

## What a new pilot is told.

firstSteps_1 = Odczyt: naciśnij „Połącz”, obudź timer, trzymaj głowicę podczerwieni blisko. Odczyt niczego nie zmienia i niczego nie porusza.
firstSteps_2 = Wgrywanie: wpisz nowe wartości, naciśnij „Wgraj”, obejrzyj każdą różnicę. „Zweryfikowano” znaczy: timer odczytano ponownie i zawiera to, czego chcesz.
firstSteps_3 = Lot: na górze strony widać, która pamięć jest wybrana na następny lot, i jej DT. Strona nie potrzebuje sieci i nic nie opuszcza tego urządzenia.

## The values of a program, with unit and range.

values_function_text = Etap lotu: w swoim czasie każde serwo idzie na swoją pozycję. Aby funkcję pominąć, nadaj jej pozycje poprzedniej funkcji.
values_function_range = Zwykle start, dziewięć funkcji i DT.
values_time_text = Kiedy zaczyna się funkcja, licząc od startu. Wpisz 12,5 albo 2:05. Dla F1B i F1E nie wiadomo, od czego timer liczy.
values_time_range = Według instrukcji. F1Q: od 0,1 do 99,9 s. F1B: od 0,01 do 9,99 s dla funkcji 1 i 2, potem od 0,1 do 99,9 s. F1E: nieznane.
values_after_text = Czas od poprzedniej funkcji. Wszystkie późniejsze funkcje przesuwają się razem z nim, DT nie.
values_position_name = Pozycja
values_position_text = Gdzie stoi serwo. Kąt jednego kroku zależy od serwa i popychacza: wypróbuj to w widoku „{ views_names_bench }”.
values_position_range = Od 0 do 130 kroków.
values_motorStop_text = F1Q: kiedy silnik staje, licząc od startu. Żadne serwo się przy tym nie porusza.
values_motorStop_range = Według instrukcji od 0,1 do 99,9 s, co 0,1 s.
values_dt_text = Determalizator: kiedy sprowadza model na ziemię, licząc od startu. Czas jest czerwony, gdy jest krótszy niż twój limit.
values_dt_range = Od 1 do 720 s według instrukcji. Więcej niż 10:55 min nie da się wysłać.
values_idleThrottle_text = F1Q: prawdopodobnie jak szybko obraca się silnik, gdy przycisk startu jest wciśnięty.
values_idleThrottle_range = Strona zakłada od 0 do 100. Jednostka nie jest znana.
values_memory_text = Timer ma kilka pamięci, w każdej jest jeden program. W następnym locie działa pamięć wybrana. Podgląd innej wybiera ją i wraca; jeśli zostanie przerwany, strona mówi, która pamięć jest być może wybrana na następny lot.
values_memory_range = Zwykle cztery, od M1 do M4. Starsze timery mają pięć.

## What a pilot checks before a flight.

checklist_lead = Zaznacz każdy punkt. Zaznaczenia są na jeden lot i nie są zachowywane.
checklist_items_memory = Na następny lot wybrana jest właściwa pamięć.
checklist_items_dtTime = Czas DT powiedziany na głos.
checklist_items_surfaces = Skrzydło, statecznik i ster kierunku siedzą mocno i stoją tak, jak powinny.
checklist_items_battery = Akumulator jest naładowany, a jego wtyczka wciśnięta do końca.
checklist_items_dtSeen = Serwo na moich oczach przestawiło się na DT.
checklist_items_radioDt = DT przez radio wypróbowane, jeśli jest.
checklist_items_switch = Przycisk startu wciśnięty pięć razy i za każdym razem odskoczył.
checklist_items_propeller = Śmigło jest mocno zamocowane i obraca się swobodnie. Nikt przed nim nie stoi.
checklist_known_now = Następny lot: { $memory }, DT{"\u00a0"}{ $dt }, odczyt { $time }.
checklist_known_onceAt = Ostatni odczyt { $time }: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_once = Ostatni odczyt: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_not = Nie wiadomo, co zawiera { $memory }. Odczytaj ją przed lotem.
checklist_known_nothing = Nie odczytano żadnego timera. Połącz się z timerem, aby zobaczyć tu pamięć następnego lotu i jej DT.
checklist_known_unwritten =
    { $count ->
        [one] { $count } zmiana jeszcze nie jest w timerze.
        [few] { $count } zmiany jeszcze nie są w timerze.
       *[many] { $count } zmian jeszcze nie jest w timerze.
    }
checklist_left = Zostało punktów: { $count }
checklist_done = Wszystko zaznaczone. Udanego lotu.
checklist_again = Usuń zaznaczenia

## Problems as a pilot sees them, and what to do.

troubles_symptoms_noAnswer_title = Timer nie odpowiada
troubles_symptoms_noAdapter_title = Strona nie znajduje adaptera
troubles_symptoms_refused_title = Adapter się nie otwiera
troubles_symptoms_wrongValues_title = Wartości wyglądają na błędne
troubles_symptoms_wrongValues_steps_1 = Spójrz na górę strony: którą pamięć widać i która jest wybrana na następny lot?
troubles_symptoms_wrongValues_steps_2 = Naciśnij „{ program_read }”.
troubles_symptoms_wrongValues_steps_3 = Czy czasy maleją z wiersza na wiersz? Wtedy strona pyta, jak je czytać.
troubles_symptoms_wrongValues_steps_4 = Przy F1B i F1E porównaj czasy z programatorem ręcznym.
troubles_symptoms_cutOff_title = Wgrywanie zostało przerwane
troubles_symptoms_cutOff_steps_1 = Na razie nie lataj tym modelem. Połącz się: strona odczyta timer, a potem zaproponuje dokończenie wgrywania albo wgranie dawnych wartości.
troubles_symptoms_cutOff_steps_2 = To, co timer zawierał przedtem, jest w widoku „{ views_names_memories }”, „{ backups_title }”.
troubles_symptoms_noDt_title = DT nie zadziała albo zadziała w złym czasie
troubles_symptoms_noDt_steps_1 = Spójrz na górę strony: jest tam pamięć wybrana na następny lot i jej DT. Inna pamięć ma inne DT.
troubles_symptoms_noDt_steps_2 = Czy przycisk startu za każdym razem odskakuje? Dopóki jest wciśnięty, sekwencja się nie zaczyna i DT nie zadziała.
troubles_symptoms_noDt_steps_3 = Czy akumulator jest naładowany, a jego wtyczka wciśnięta do końca? Gdy timer nie działa, DT nie zadziała.
troubles_symptoms_noDt_steps_4 = Trzymaj pewnie model i naciśnij wiersz DT w widoku „{ views_names_bench }”. Czy serwo idzie na swoją pozycję DT i zwalnia to, co trzyma?
troubles_symptoms_noDt_steps_5 = Zdejmij śmigło i pozwól timerowi dojść do końca. Nie lataj, dopóki nie zobaczysz, że serwo porusza się w chwili DT.
troubles_symptoms_noMove_title = Serwo się nie porusza
troubles_symptoms_noMove_steps_1 = Trzymaj model i naciśnij w widoku „{ views_names_bench }” wiersz funkcji, w której serwo ma się poruszyć. Nic się nie porusza? Sprawdź wtyczkę i akumulator. Tam się porusza, a w locie nie? Ma tę samą pozycję co w poprzedniej funkcji.
troubles_symptoms_noMove_steps_2 = Idzie w inne miejsce, niż podaje tabela? Być może niektóre timery zapamiętują pozycję tylko dla funkcji, przy której stoją serwa. Strona proponuje wtedy przestawianie serw podczas wgrywania.
troubles_symptoms_noMove_steps_3 = Brzęczy albo staje za wcześnie? Może blokuje je popychacz: spróbuj mniejszego ruchu.
troubles_symptoms_noMotor_title = Silnik nie rusza
troubles_symptoms_noMotor_steps_1 = Po locie timer blokuje silnik. Aby go odblokować, trzymaj model, a ręce trzymaj z dala od śmigła: śmigło może ruszyć. Potem przytrzymaj przycisk „{ bench_unlock }” w widoku „{ views_names_bench }”.
troubles_symptoms_noMotor_steps_2 = Czy przycisk startu odskoczył? Dopóki jest wciśnięty, silnik pracuje tylko na wolnych obrotach.
troubles_symptoms_noMotor_steps_3 = Czy stop silnika nie jest za wcześnie? Przy 0,1 s silnik staje zaraz po ruszeniu.
troubles_symptoms_noLibrary_title = Nie ma moich modeli i programów
troubles_symptoms_noLibrary_steps_1 = Wyczyść pole wyszukiwania, naciśnij „Archiwum”.
troubles_symptoms_noLibrary_steps_2 = Każda przeglądarka, profil i adres ma własną bibliotekę; okno prywatne ją usuwa.
troubles_symptoms_noLibrary_steps_3 = Na innym urządzeniu albo po utracie: „{ files_import_button }” i plik z ostatniego eksportu.

## What to do, step by step, when a timer cannot be reached.

help_title = Co zrobić
help_steps_programs = Zamknij inne karty i programy, które używają adaptera, na przykład Arduino IDE, PuTTY, program drukarki 3D albo konfigurator dronów.
help_steps_replug = Odłącz adapter, odczekaj pięć sekund, podłącz go znowu. Jeśli to nie pomoże, uruchom ponownie komputer.
help_steps_cable = Podłącz adapter bezpośrednio, bez rozdzielacza USB, i wypróbuj inny kabel. Wiele kabli USB służy tylko do ładowania.
help_steps_windows = Windows: otwórz Menedżera urządzeń. Żółty znak przy adapterze oznacza, że brakuje sterownika: połącz się z internetem i uruchom Windows Update.
help_steps_mac = Mac: zezwól na akcesorium, gdy Mac o nie zapyta. Starszy macOS wymaga sterownika producenta.
help_steps_linux = Linux może nie pozwalać na użycie adaptera. Uruchom to polecenie, potem wyloguj się i zaloguj.
help_steps_linux-container = Adapter mógł zostać przejęty przez Linuksa na Chromebooku. Wyłącz adapter w Ustawieniach: Środowisko programistyczne Linux, Zarządzaj urządzeniami USB.
help_steps_android = Na Androidzie potrzebny jest { android }. { restWorks }
help_steps_bluetooth = Bluetooth: sparuj adapter w ustawieniach systemu (kod 1234 lub 0000), trzymaj go włączony i blisko, a na innych urządzeniach, które go używają, wyłącz Bluetooth.
help_steps_firefox-finds = Firefox nie znajduje adapterów Bluetooth, a gdy pochodzi ze sklepu Ubuntu, nie znajduje żadnych. Użyj Chrome.
help_steps_firefox-reload = Firefox zatrzymuje adapter, który zawiódł. Wczytaj tę stronę ponownie. To, co wpisano, jest zachowane.
help_steps_switch = { link_stages_steps_switch }
help_steps_near = { link_stages_steps_near }
help_steps_battery = Czy akumulator timera jest naładowany i podłączony? Gdy akumulator jest pusty, timer stoi w położeniu DT.
help_steps_restarts = Niektóre adaptery uruchamiają się od nowa przy każdym otwarciu portu (resetuje je DTR) i przez kilka sekund nic nie słyszą. Jeśli twój tak robi, ustaw jego prędkość: Ustawienia, „{ ports_settings }”. Wtedy port jest otwierany tylko raz. Sama strona zostawia DTR tak, jak ustawi go przeglądarka.
help_steps_usual-settings = Otwórz Ustawienia, „{ ports_settings }”, i naciśnij „{ ports_reset }”: strona sama znajdzie wtedy prędkość.
help_steps_report = Jeśli to się powtórzy: Ustawienia, Ekspert, Linia, „{ line_copyReport }”. Wyślij raport na adres:
help_steps_address = Otwórz ten adres w karcie:
help_page = Wszystkie kroki, dla każdego systemu

## For when the browser does not store, or give back, what it should.

keeping_title = Ta przeglądarka nie zachowuje wszystkiego.
keeping_notKept = To, co wpisujesz, kopie zapasowe i notatka o przerwanym wgrywaniu istnieją tylko, dopóki ta strona jest otwarta. Eksportuj bibliotekę. Potem zamknij inne karty tej strony albo zwolnij miejsce na tym urządzeniu.
keeping_notKnown = Przeglądarka nie podaje, czy zachowuje to, co robisz. Przyjmij, że nie, i eksportuj bibliotekę.
keeping_oneTab = Używaj tylko jednej karty tej strony.
keeping_emptied = Przeglądarka usunęła to, co zachowała dla tej strony. Eksportuj to, co jeszcze widzisz.
keeping_export = Eksportuj bibliotekę…

## Stored data that cannot be read.

aside_title =
    { $count ->
        [one] 1 rekordu nie udało się odczytać. Jest odłożony, nie usunięty.
        [few] { $count } rekordów nie udało się odczytać. Są odłożone, nie usunięte.
       *[many] { $count } rekordów nie udało się odczytać. Są odłożone, nie usunięte.
    }
aside_write = Jest wśród nich notatka o przerwanym wgrywaniu: odczytaj timer przed lotem.
aside_save = Zapisz do pliku

## “2 models, 1 program”: only kinds that there are.

counted_models =
    { $count ->
        [one] { $count }{"\u00a0"}model
        [few] { $count }{"\u00a0"}modele
       *[many] { $count }{"\u00a0"}modeli
    }
counted_settings =
    { $count ->
        [one] { $count }{"\u00a0"}program
        [few] { $count }{"\u00a0"}programy
       *[many] { $count }{"\u00a0"}programów
    }
counted_flights =
    { $count ->
        [one] { $count }{"\u00a0"}lot
        [few] { $count }{"\u00a0"}loty
       *[many] { $count }{"\u00a0"}lotów
    }
counted_backups =
    { $count ->
        [one] { $count }{"\u00a0"}kopia zapasowa
        [few] { $count }{"\u00a0"}kopie zapasowe
       *[many] { $count }{"\u00a0"}kopii zapasowych
    }

## What was deleted a moment ago.

removed = Usunięto: { $what }.

## Deletes everything that this device keeps.

erase_open = Usuń wszystko z tego urządzenia…
erase_lead = To usuwa z tej przeglądarki wszystkie modele, programy, loty, kopie zapasowe, niewgrane zmiany i ustawienia tej strony. Tego nie można cofnąć. Timery zachowują swoją zawartość.
erase_uncertain = Wgrywanie zostało przerwane i nie wiadomo, co zawiera tamten timer. Bez notatki o tym wgrywaniu strona nie może cię ostrzec: odczytaj tamten timer przed lotem.
erase_start = Usuń wszystko
erase_running = Usuwanie
erase_failed = Nie wszystko udało się usunąć. Zamknij inne karty tej strony i spróbuj ponownie albo usuń jej dane w ustawieniach przeglądarki.

## For a page that is shown inside another page.

framed_title = Sidus Timer działa tylko we własnej karcie: inna strona mogłaby zasłonić to, co widzisz ze swojego timera.
framed_open = Otwórz Sidus Timer we własnej karcie

## What is known about the content of a timer, and what is not.

knowledge_title = Niepewne
knowledge_uncertain = Nie wiadomo, co zawiera { $memory }: { $values }.
knowledge_noFly = Nie lataj, dopóki tego nie odczytasz.
knowledge_since = Przerwane wgrywanie, początek: { $time }.
knowledge_thisMemory = bieżąca pamięć
knowledge_memoryOf = { $memory } ({ $timer })
knowledge_timer_here = timer { $name } { $firmware }
knowledge_timer_simulated = symulowany timer { $name } { $firmware }
knowledge_otherTimer_here = inny timer { $name } { $firmware }
knowledge_otherTimer_simulated = inny symulowany timer { $name } { $firmware }
knowledge_motorStop = stop silnika
knowledge_either = { $name } to { $before } albo { $goal }
knowledge_list =
    { $more ->
        [one] { $named }, a także { $more }{"\u00a0"}inna{"\u00a0"}wartość jest niepewna
        [few] { $named }, a także { $more }{"\u00a0"}inne{"\u00a0"}wartości są niepewne
       *[many] { $named }, a także { $more }{"\u00a0"}innych{"\u00a0"}wartości jest niepewnych
    }
knowledge_and = { $first } i { $next }
knowledge_connect = Połącz i odczytaj
knowledge_forget = Zapomnij o tym…
knowledge_forgetSure = Zapomnij o tym tylko wtedy, gdy tamten timer odczytano gdzie indziej albo już go nie masz.
knowledge_forgetNow = Zapomnij teraz
knowledge_verified = Jak w timerze, zweryfikowano { $time }
knowledge_readAt = Jak w timerze, odczyt { $time }
knowledge_lastReadAt = Jak w ostatnim odczycie, { $time }
knowledge_lastRead = Jak w ostatnim odczycie
knowledge_ofSetting =
    { $changes ->
        [0] { $name }: zapisany
        [one] { $name }: { $changes } zmiana niezapisana
        [few] { $name }: { $changes } zmiany niezapisane
       *[many] { $name }: { $changes } zmian niezapisanych
    }
knowledge_changed = { $name }, zmieniony
knowledge_ofModel = { $name } ({ $model })
knowledge_made = Nowy program, jeszcze w żadnym timerze
knowledge_unknown = Nie wiadomo, co zawiera { $memory }
knowledge_unfinished =
    { $count ->
        [one] { $count } pole nie ma jeszcze wartości
        [few] { $count } pola nie mają jeszcze wartości
       *[many] { $count } pól nie ma jeszcze wartości
    }
knowledge_hints_now = Wyróżnione pola różnią się od tego, co zawiera timer.
knowledge_hints_onceAt = Wyróżnione pola różnią się od ostatniego odczytu, { $time }.
knowledge_hints_once = Wyróżnione pola różnią się od ostatniego odczytu.
knowledge_marks_now = było { $value }
knowledge_marks_once = ost. odczyt: { $value }
knowledge_notCertain = , obecnie niepewne
knowledge_held_now = W timerze
knowledge_held_once = Ostatni odczyt

## Why a program of the library or from a link cannot be opened now.

obstacles_busy = Strona odczytuje, wgrywa albo szuka timera. Poczekaj, aż skończy.
obstacles_following = Serwa podążają. Najpierw to zakończ.
obstacles_not-fitting = { notFitting }

## Models and their saved programs.

library_unread = Przeglądarka nie może teraz odczytać biblioteki. Zamknij inne karty tej strony i spróbuj ponownie.
library_empty_title = Nie ma jeszcze modelu
library_empty_lead = Model zawiera swoje programy, z nazwami i notatkami. Są przechowywane tylko na tym urządzeniu.
library_empty_hint = Utwórz model albo odczytaj timer i zapisz jego program.
library_search_label = Szukaj programów
library_search_nothing = Żaden program nie zawiera wszystkich tych słów.
library_models_title = Modele
library_models_all = Wszystkie modele
library_models_make = Nowy model…
library_models_settings =
    { $count ->
        [one] { $count } program
        [few] { $count } programy
       *[many] { $count } programów
    }
library_models_archive = Archiwum ({ $count })
library_models_archived = w archiwum
library_models_latest = Ostatnio zmienione
library_list_open = na ekranie
library_model_timerClass = Klasa
library_model_noClass = Nie podano
library_model_facts = O tym modelu
library_model_noSettings = Nie ma jeszcze programu.
library_model_servos = Serwa
library_model_servosUnknown = Najpierw zapisz program tego modelu.
library_model_servoWay = od { $low } do { $high } kroków
library_model_archive = Do archiwum
library_model_unarchive = Wyjmij z archiwum
library_model_remove = Usuń model
library_model_withSettings =
    { $count ->
        [one] Razem z nim zostanie usunięty jego program. „Cofnij” przywraca oba.
        [few] Razem z nim zostaną usunięte jego { $count }{"\u00a0"}programy. „Cofnij” przywraca wszystko.
       *[many] Razem z nim zostanie usuniętych jego { $count }{"\u00a0"}programów. „Cofnij” przywraca wszystko.
    }
library_setting_isOpen = Na ekranie: zobacz
library_setting_loadAgain =
    { $count ->
        [one] Otwórz ponownie: wróci { $count } wartość
        [few] Otwórz ponownie: wrócą { $count } wartości
       *[many] Otwórz ponownie: wróci { $count } wartości
    }
library_setting_tags = Tagi, oddzielone przecinkami
library_setting_from_typed = wpisany
library_setting_from_timer = odczytany z timera
library_setting_from_simulated = odczytany z symulowanego timera
library_setting_from_backup = z kopii zapasowej
library_setting_from_file = z pliku
library_setting_from_link = z linku
library_setting_origin = { $source }, { $time }
library_setting_notShown = Nie udało się go otworzyć. Spróbuj ponownie.
library_setting_gone = Nie ma go już w bibliotece.
library_save_open = Zapisz…
library_save_over = Nadpisz: { $program }
library_save_undo = Cofnij zapis: { $name }
library_save_crossing = To wartości modelu { $from }. Zapisz je pod modelem { $to }.
library_save_asNew = Zapisz jako nowy…
library_save_taken = Program { $program } już jest. Wpisz inną nazwę albo:
library_save_replace = Nadpisz go. Jego wartości zostaną jako wcześniejsza wersja.
library_save_name =
    { $of ->
        [program] Nazwa programu
       *[model] Nazwa modelu
    }
library_save_namePlace = Na przykład: dogrywka, cisza
library_save_notSavable = Pole nie ma wartości. Najpierw je popraw.
library_save_state =
    { $changes ->
        [0] { $name }: zapisany
        [one] { $name }: { $changes } zmiana niezapisana
        [few] { $name }: { $changes } zmiany niezapisane
       *[many] { $name }: { $changes } zmian niezapisanych
    }
library_nameNeeded = Potrzebna jest nazwa.

## The log of the line.

line_empty = Nie ma nic do pokazania.
line_unused = Na linii nic jeszcze nie było. Możesz też wczytać nagranie i odtworzyć je jako timer.
line_all = Wszystko
line_out = Do timera
line_in = Z timera
line_damaged = Uszkodzone
line_request = { $name } · { $letters }
line_reply = { $name }, odpowiedź · { $letters }
line_echo = { $name }, echo · { $letters }
line_unknown = Nieznana litera { $letter }
line_names_GETTIMERS = Odczyt czasów
line_names_SETTIMERS = Wgranie czasów
line_names_GETSERVOPOS = Odczyt pozycji
line_names_SETSERVO = Wgranie pozycji
line_names_MOVETOFUNC = Ruch serw
line_names_GETSWVER = Identyfikacja
line_names_UNLOCK = Odblokowanie silnika
line_names_JUMP2 = Skok
line_names_GETMEMORY = Która pamięć
line_names_SETMEMORY = Wybór pamięci
line_names_GETLOWRPM = Odczyt wolnych obrotów
line_names_SETLOWRPM = Wgranie wolnych obrotów
line_rejected_noise = Uszkodzone: szum
line_rejected_length = Uszkodzone: niemożliwa długość
line_rejected_terminator = Uszkodzone: brak końca tam, gdzie powinien być
line_rejected_checksum = Uszkodzone: zła suma kontrolna
line_rejected_silence = Uszkodzone: ucięte
line_error_framing = Błąd linii: ramkowanie
line_error_parity = Błąd linii: parzystość
line_error_break = Błąd linii: przerwa
line_error_overrun = Błąd linii: przepełnienie, bajty przepadły
line_error_other = Błąd linii innego rodzaju
line_position = { $slot }, { $servo }: krok { $steps }
line_motorStop = stop silnika { $time }
line_reserved = zarezerwowane { $time }
line_functions = funkcje { $times }
line_identity = { $name }, firmware { $firmware }, { $functions } i DT, { $memories }, { $servos }
line_memories =
    { $count ->
        [one] { $count } pamięć
        [few] { $count } pamięci
       *[many] { $count } pamięci
    }
line_memoryUnsaid = Nie podaje, która.
line_idleThrottle = { $value }, jednostka nieznana
line_idleThrottleUnsaid = Nie podaje wartości.
line_acknowledged = Potwierdzono.
line_unreadable_wrong-length = Zawartość jest dłuższa lub krótsza, niż powinna być.
line_unreadable_unknown-command = Nie wiadomo, co to znaczy.
line_unreadable_unexpected-reply = To odpowiedź na inne zapytanie.
line_unreadable_bad-identity = To, co mówi o timerze, nie może być prawdą.
line_unreadable_identity-needed = Da się to odczytać, gdy timer powie, czym jest.
line_unreadable_out-of-range = Jedna z wartości nie może być poprawna.
line_unreadable_not-an-integer = { line_unreadable_out-of-range }
line_unreadable_wrong-count = { line_unreadable_out-of-range }
line_unreadable_wrong-type = { line_unreadable_out-of-range }
line_unreadable_unknown-word = Nie można odczytać zawartości.
line_unreadable_bad-capture = { line_unreadable_unknown-word }
line_unreadable_bad-file = { line_unreadable_unknown-word }
line_unreadable_bad-link = { line_unreadable_unknown-word }
line_unreadable_newer-version = { line_unreadable_unknown-word }
line_unreadable_too-large = { line_unreadable_unknown-word }
line_unreadable_duplicate = { line_unreadable_unknown-word }
line_goOn = Dalej
line_came =
    { $number ->
        [one] Wstrzymano. Od tego czasu { $number } wpis.
        [few] Wstrzymano. Od tego czasu { $number } wpisy.
       *[many] Wstrzymano. Od tego czasu { $number } wpisów.
    }
line_clear = Wyczyść
line_unidentified = nieznany
line_load = Wczytaj…
line_filter = Pokaż
line_searchHint = nazwa lub hex
line_counts_out = do timera: { $count }
line_counts_in = z timera: { $count }
line_counts_damaged = uszkodzone: { $count }
line_counts_errors =
    { $count ->
        [one] { $count } błąd linii
        [few] { $count } błędy linii
       *[many] { $count } błędów linii
    }
line_recording =
    { $entries ->
        [one] { $name }: nagranie, { $entries } wpis.
        [few] { $name }: nagranie, { $entries } wpisy.
       *[many] { $name }: nagranie, { $entries } wpisów.
    }
line_replay = Odtwórz jako timer
line_cannotReplay = Nie można tego odtworzyć: timer ani razu nie mówi, czym jest.
line_back = Wróć do linii na żywo
line_noRecordingAt = Wiersz { $line }: oczekiwano czasu w sekundach, > lub < oraz bajtów w hex.
line_noRecording = Ten plik nie jest nagraniem.
line_send_title = Wyślij ramkę ręcznie
line_send_lead = Strona dodaje długość i sumę kontrolną.
line_send_bytes = Litera i dane, w hex
line_send_faults_hex = Wpisz dwie cyfry hex na każdy bajt, od 0 do 9 lub od A do F.
line_send_faults_too-long = Ramka mieści najwyżej 252 bajty.
line_send_preview = Zostanie wysłane
line_send_send = Wyślij…
line_send_confirmTitle = Wysłać tę ramkę do timera?
line_send_danger = Serwa mogą się poruszyć, śmigło może ruszyć, a zawartość timera może się zmienić. Potem timer zostanie odczytany ponownie.
line_send_confirm = Tak, wyślij raz
line_send_sending = Wysyłanie
line_send_answered = Odpowiedź:
line_send_unanswered = Odpowiedź nie przyszła. To, czego żądała ramka, mogło się mimo to stać.
line_copyReport = Kopiuj raport

## From the ports to a timer that answers.

link_portNames_ftdi = Adapter FTDI
link_portNames_cp210x = Adapter CP210x (Silicon Labs)
link_portNames_ch340 = Adapter CH340 (WCH)
link_portNames_pl2303 = Adapter PL2303 (Prolific)
link_portNames_bluetooth = Bluetooth
link_portNames_usb = Adapter USB
link_portNames_other = Port szeregowy
link_stages_choosing = Wybierz adapter timera
link_stages_openingLong_title = Adapter długo się otwiera
link_stages_openingLong_advice = Bluetooth: włącz adapter i połóż go blisko. Kabel: odłącz go i podłącz znowu.
link_stages_asking = Pytam z prędkością { $rate } bodów.
link_stages_noAnswer = Brak odpowiedzi od { $seconds } s. Strona pyta dalej i sama przejdzie do następnego kroku.
link_stages_open = Adapter jest otwarty
link_stages_steps_switch = Obudź timer: naciśnij krótko jego przycisk
link_stages_steps_near = Trzymaj głowicę podczerwieni bliżej niż 20 cm, nie w słońcu
link_stages_steps_other = Czy timer jest na innym adapterze?
link_refused = Strona próbuje jeszcze przez 15 sekund. Adapter może być zajęty przez inny program.
link_heard_title = Coś słychać, ale żaden timer nie odpowiada.
link_heard_advice = Obudź timer i trzymaj głowicę bliżej, nie w słońcu, albo wybierz inny adapter.
link_slow_title = Timer odpowiada, ale zbyt wolno.
link_slow_advice = Jego bajty przychodzą pojedynczo przy { $rate } bodach, z tak długimi przerwami, że żadna odpowiedź nie dociera na czas w całości. Ta strona nie może go odczytać. Wypróbuj inny adapter albo kabel zamiast Bluetooth.
link_itSaid = Przyszło: { $bytes } („{ $text }”).
link_trySelectBare = Spróbuj bez poprawnej sumy kontrolnej
link_lost_title = Połączenie z adapterem zostało utracone.
link_lost_advice = Podłącz go albo zbliż: strona sama wznowi pracę. To, co wpisano, jest zachowane.
link_status_off = Nie połączono
link_status_opening = Łączenie
link_status_searching = Szukanie timera
link_status_away = Utracono połączenie
link_status_closing = Rozłączanie

## The known ports, and how they are opened.

ports_title = Znane adaptery
ports_forget = Zapomnij
ports_settings = Ustawienia szeregowe
ports_settingsHint = Tylko dla nietypowego adaptera. Strona sama znajduje prędkość.
ports_rate = Prędkość
ports_findRate = Znajdź
ports_baud = { $rate } bodów
ports_parity = Parzystość
ports_parities_none = Brak
ports_parities_even = Parzysta
ports_parities_odd = Nieparzysta
ports_stopBits = Bity stopu
ports_dtr = DTR
ports_rts = RTS
ports_signals_leave = Tak, jak ustawi przeglądarka
ports_signals_on = Włączony
ports_signals_off = Wyłączony
ports_reset = Zwykłe ustawienia

## What is known about the connected timer. Its numbers are in the report.

aboutTimer_title = O tym timerze
aboutTimer_damage = Uszkodzenia zauważone na linii
aboutTimer_crowd = W wiązce może być inny timer albo programator. Od tego czasu dwa odczyty muszą być zgodne.
aboutTimer_found = Co zrobił inaczej
aboutTimer_nothingFound = Na razie nic: wszystko, o co proszono, zrobił w zwykły sposób.
aboutTimer_quirkNames_timers-reply-66 = Odpowiada literą innego polecenia.
aboutTimer_quirkNames_unlock-reply-6a = { aboutTimer_quirkNames_timers-reply-66 }
aboutTimer_quirkNames_memory-unknown = Nie podaje, która pamięć jest bieżąca.
aboutTimer_quirkNames_memory-impossible = { aboutTimer_quirkNames_memory-unknown }
aboutTimer_quirkNames_bare-checksum = Na pytanie o wolne obroty nie odpowiada jak zwykle.
aboutTimer_quirkNames_times-big-endian = Jego czasy maleją. Po zamianie dwóch bajtów każdego czasu by rosły.
aboutTimer_quirkNames_servo-first = Przy wgrywaniu pozycji przyjmuje serwo przed funkcją.
aboutTimer_quirkNames_servo-unanswered = Nie odpowiedział, gdy wgrywano pozycję.
aboutTimer_quirkNames_times-rounded = Zaokrągla czasy.
aboutTimer_quirkNames_memories-from-one = Liczy swoje pamięci od 1.
aboutTimer_quirkNames_positions-unchanged = Potwierdził pozycje, ale ich nie zachował.
aboutTimer_quirkNames_echo = Adapter odsyła to, co do niego wysłano.
aboutTimer_quirkNames_idle-throttle-unanswered = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_identity-unusual = W tym, co mówi o sobie, są nieznane bajty.
aboutTimer_quirkNames_idle-throttle-malformed = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_replies-alike = Jego odpowiedzi na niektóre zapytania są uszkodzone, każda w ten sam sposób.
aboutTimer_assumed = Znane różnice
aboutTimer_assumedHint = Zapamiętane dla tego adaptera i tego rodzaju timera.
aboutTimer_forget = Zapomnij znane różnice
aboutTimer_assumptions_bigEndianTimes = Dwa bajty każdego czasu są zamienione
aboutTimer_assumptions_servoFirst = { aboutTimer_quirkNames_servo-first }
aboutTimer_assumptions_memoriesFromOne = { aboutTimer_quirkNames_memories-from-one }
aboutTimer_assumptions_bareChecksumRequests = „Wybór pamięci” i „Wgranie wolnych obrotów” są wysyłane bez poprawnej sumy kontrolnej
aboutTimer_assumptions_positionsNeedMove = Pozycje są zachowywane tylko tam, gdzie stoją serwa

## Which memory flies next, and what is known about the others.

nextFlight_badge = następny lot
nextFlight_onScreen = To jest { $memory }.
nextFlight_named = { $memory }, następny lot
nextFlight_other = Następny lot: { $memory }.
nextFlight_last = Gdy timer ostatnio odpowiedział, bieżąca była { $memory }. To ona jest wybrana na następny lot, chyba że coś innego to zmieniło.
nextFlight_original = Przy połączeniu bieżąca była { $original }.
nextFlight_originalUnknown = Nie wiadomo, która była bieżąca przy połączeniu.
nextFlight_unknown = Nie wiadomo, która pamięć jest wybrana na następny lot.
nextFlight_asked = Ostatnio wybrano: { $memory }.
nextFlight_back = Wróć do { $original }
nextFlight_leaving_title = Zanim się rozłączysz
nextFlight_leaving_back = Wróć do { $original } i rozłącz
nextFlight_leaving_failed = Timer nie wrócił do { $original }. Połączenie nadal trwa.

## The last reading of a memory that is not current.

look_read = { $memory }, odczyt { $time }
look_notRead = { $memory } nie została odczytana
look_either = Albo
look_or = lub
look_lead = Tylko do podglądu. Następny lot: { $current }.
look_edit = Edytuj { $memory }
look_look = Podejrzyj { $memory }
look_hint = To wybiera { $memory }, odczytuje ją i wraca do { $current }.
look_fly = Wybierz { $memory } na lot
look_show = Pokaż { $memory }

## Jobs over several memories, and the backups.

memories_copy = Kopiuj { $from } do { $to }
memories_restore = Przywróć kopię zapasową
memories_restoreAll = Przywróć wszystkie ({ $count })…
memories_plans_screen =
    { $keepsThrottle ->
        [true] Czasy i pozycje z ekranu zostaną wgrane. Pamięć: { $to }. Jej obecna zawartość trafi najpierw do kopii zapasowej. Wolne obroty pozostaną bez zmian.
       *[false] Czasy i pozycje z ekranu zostaną wgrane. Pamięć: { $to }. Jej obecna zawartość trafi najpierw do kopii zapasowej.
    }
memories_plans_copy = { $to } będzie zawierać czasy i pozycje z { $from }, odczytane przed chwilą. To, co { $to } zawiera teraz, trafi najpierw do kopii zapasowej.
memories_plans_restore = To wgra zawartość kopii zapasowej ({ $time }). Pamięć: { $names }. To, co jest tam teraz, trafi najpierw do kopii zapasowej.
memories_atEnd = Na końcu na następny lot znów będzie wybrana { $current }.
memories_refused = { $memory }: nic nie można wgrać, bo żadne oprogramowanie nie może wysłać tych wartości.
memories_untouched = { $memory }: nic nie wgrano.
memories_stopped = To, czego jeszcze nie wgrano, jest w timerze jak przedtem.

## All memories of a timer at a glance.

overview_readAll = Odczytaj i zachowaj wszystkie
overview_copyTo = Kopiuj do…
overview_compareWith = Porównaj z { $memory }
overview_readAt = odczyt { $time }
overview_notCertain = Niepewne: wgrywanie do tej pamięci zostało przerwane. Pokazano stan sprzed tego wgrywania.
overview_edited = Pokazywana i kopiowana tak, jak ją zawiera timer, bez twoich zmian.
overview_same = Zawierają to samo.
overview_differs =
    { $count ->
        [one] Różni się { $count } wartość.
        [few] Różnią się { $count } wartości.
       *[many] Różni się { $count } wartości.
    }

## How the timer writes its times: the question that no reading can answer.

byteOrder_title = Czasy tego timera maleją z wiersza na wiersz.
byteOrder_advice = Rosłyby, gdyby zamienić dwa bajty każdego czasu. Porównaj z tym, co wiesz o timerze, i wybierz, zanim coś wgrasz.
byteOrder_keep = Są dobre tak, jak pokazano
byteOrder_exchange = Zamień je i odczytaj ponownie

## Why there is no connection.

connection_unsupported_title = { unsupportedHere_title }
connection_unsupported_advice = { unsupportedHere_advice }
connection_insecure_title = Przeglądarka nie zezwala tu na porty szeregowe.
connection_insecure_advice = { restWorks }
connection_policy_title = Serwer tej strony zabrania portów szeregowych.
connection_policy_advice = { restWorks }
connection_nothing-chosen_title = Nie wybrano adaptera.
connection_nothing-chosen_advice = Naciśnij „Połącz” i wybierz adapter. Jeśli nie ma go na liście, pomogą kroki poniżej.
connection_not-allowed_title = { connection_insecure_title }
connection_not-allowed_advice = Zezwól tej stronie na porty szeregowe w ustawieniach przeglądarki, potem znów naciśnij „Połącz”.
connection_busy_title = Adapter się nie otwiera.
connection_busy_advice = Najczęściej zajmuje go inny program albo karta. Zamknij je, potem znów naciśnij „Połącz”.
connection_bad-settings_title = Adapter nie przyjmuje tych ustawień.
connection_bad-settings_advice = { help_steps_usual-settings }
connection_unplugged_title = Nie można połączyć się z adapterem.
connection_unplugged_advice = Odłącz go, podłącz znowu i naciśnij „Połącz”. To, co wpisano, jest zachowane.
connection_bad-reply_title = { link_heard_title }
connection_bad-reply_advice = { link_heard_advice }
connection_lost_title = { connection_unplugged_title }
connection_lost_advice = { connection_unplugged_advice }

## Why a job with the timer has ended.

timer_no-answer_title = Timer nie odpowiedział.
timer_no-answer_advice = Naciśnij krótko przycisk timera, trzymaj głowicę bliżej niż 20 cm i spróbuj ponownie. To, co wpisano, jest zachowane.
timer_bad-reply_title = Odpowiedź timera nie może być poprawna.
timer_bad-reply_advice = Spróbuj ponownie. Jeśli to się powtórzy: Ustawienia, Ekspert, Linia, „{ line_copyReport }”.
timer_unstable_title = Linia jest zbyt zaszumiona, aby jej ufać.
timer_unstable_advice = Trzymaj głowicę podczerwieni bliżej, nie w słońcu, i spróbuj ponownie.
timer_crowded_title = W wiązce może być więcej niż jeden timer.
timer_crowded_advice = Odsuń inne timery i programatory i odczytaj ponownie.
timer_other-memory_title = Bieżąca pamięć nie jest tą z ekranu.
timer_other-memory_advice = Odczytaj ponownie, zanim coś wgrasz.
timer_memory-unknown_title = Ten timer nie podaje, która pamięć jest bieżąca.
timer_memory-unknown_advice = Dlatego strona nie może podejrzeć innej pamięci i wrócić. Możesz odczytać bieżącą i do niej wgrywać.
timer_memory-left_title = Możliwe, że na następny lot wybrana jest teraz inna pamięć.
timer_memory-left_advice = Strona nie zdołała wrócić do tej, która była bieżąca. Połącz się ponownie i przed lotem wybierz właściwą pamięć na następny lot.
timer_other-timer_title = To nie jest timer, który odpowiadał przedtem.
timer_other-timer_advice = Strona go odczytuje. Obejrzyj, co zawiera, zanim coś wgrasz.
timer_stale_title = Timer nie zawiera tego, co pokazano.
timer_stale_advice = Nic nie wgrano. Zobacz, co wgranie zmieniłoby teraz.
timer_changed_title = Timer zawiera inne wartości niż przedtem.
timer_changed_advice = Zmieniło je coś innego albo to jest inny timer. Twoje zmiany są zachowane: obejrzyj różnicę, zanim coś wgrasz.
timer_stood-still_title = Strona była przez jakiś czas wstrzymana podczas pracy z timerem.
timer_stood-still_advice = Potem nic już nie wysłano: może tam już być inny timer. Odczytaj ponownie.
timer_too-slow_title = Ten timer odpowiada zbyt wolno.
timer_too-slow_advice = Na jego odpowiedzi trzeba czekać ponad 3 sekundy, więc strona nie wie, która należy do którego pytania. Potem nic już nie wysłano. Wypróbuj inny adapter albo kabel zamiast Bluetooth.
timer_undecided_title = { byteOrder_title }
timer_undecided_advice = { byteOrder_advice }
timer_serious_title = Kontrola znalazła coś poważnego.
timer_serious_advice = { timer_stale_advice }
timer_busy_title = Coś na tej stronie lub w komputerze używa adaptera.
timer_busy_advice = Nic nie wysłano. Rozłącz i połącz ponownie. To, co wpisano, jest zachowane.
timer_port-lost_title = { link_lost_title }
timer_port-lost_advice = { link_lost_advice }
timer_aborted_title = Zatrzymano.
timer_aborted_advice = Odczytaj ponownie, aby zobaczyć, co zawiera timer.
timer_closed_title = Rozłączono.
timer_closed_advice = Aby pracować dalej, naciśnij „Połącz”. To, co wpisano, jest zachowane.

## Replies that are no noise, which is random.

alike_title = Każda odpowiedź na { $request } jest uszkodzona w ten sam sposób.
alike_advice = To nie szum: timer albo jego adapter tworzy te odpowiedzi w nieznany sposób. Włącz w ustawieniach „Ekspert”, otwórz widok „{ views_names_line }” i naciśnij „{ line_copyReport }”. Wyślij raport opiekunom projektu (github.com/sidus-timer/sidus-timer/issues).
alike_part = Tylko do podglądu: { $values }. Cała reszta jest nieznana.

## Messages that are not about errors.

notes_back_title = Twoje zmiany wróciły.
notes_back_advice = Porównaj je z tym, co zawiera timer, potem je wgraj albo cofnij.
notes_back-uncertain_title = { notes_back_title }
notes_back-uncertain_advice = Nie wiadomo, czy zostały wgrane. Połącz się z timerem i odczytaj go przed lotem.
notes_moved_title = { timer_changed_title }
notes_moved_advice = { timer_changed_advice }
notes_timer-moved_title = { timer_changed_title }
notes_timer-moved_advice = { timer_changed_advice }
notes_kept_title = Twoje zmiany są zachowane na tym urządzeniu.
notes_kept_advice = Nie pasują do tego, co teraz odczytano. Wrócą, gdy ponownie odczytasz tamtą pamięć; są też na liście na stronie początkowej.
notes_other-kind_title = Jest tu teraz timer innego rodzaju.
notes_other-kind_advice = { timer_other-timer_advice }
notes_write-completed_title = Przerwane wgrywanie jest kompletne.
notes_write-completed_advice = Timer odczytano ponownie i zawiera wszystko, co miało być wgrane.
notes_nothing-written_title = { write_refused }
notes_nothing-written_advice = {""}
notes_not-backed-up_title = { write_unkept_title }
notes_not-backed-up_advice = { keeping_notKept }
notes_select-unanswered_title = Timer nie odpowiedział, gdy wybierano pamięć.
notes_select-unanswered_advice = Na inne zapytania odpowiada. Spróbuj ponownie albo bez poprawnej sumy kontrolnej.
notes_backed-up_title = Odczytano wszystkie pamięci i zachowano kopię zapasową każdej z nich.
notes_backed-up_advice = {""}
notes_strays_title = { timer_crowded_title }
notes_strays_advice = { timer_crowded_advice }
notes_made-laid_title = Tabela pokazuje twój program, a nie to, co zawiera timer.
notes_made-laid_advice = Nic nie wgrano. Różnice są wyróżnione. „{ undo }” pokazuje, co zawiera timer.
notes_unexpected_title = Na tej stronie coś się nie powiodło.
notes_unexpected_advice = Potem nic już nie wysłano. Wczytaj stronę ponownie. To, co wpisano, jest zachowane.

## The flight of the program, and what the servos of the model move.

preview_title = Podgląd lotu
preview_guessed = Nie w skali.
preview_nameServos = Nazwij serwa…
preview_play = Odtwórz
preview_speed = Tempo
preview_time = Czas lotu
preview_launch = Start
preview_at = { $what } ({ $time })
preview_sketch = Model z boku i jego ster kierunku z góry
preview_motor_true = Wznoszenie, silnik pracuje
preview_motor_false = Lot ślizgowy, silnik stoi
preview_flies = W locie
preview_comesDown = DT: model opada
preview_duties_rudder = Ster kierunku
preview_duties_tailplane = Statecznik
preview_duties_wing = Skrzydło
preview_duties_release = Krążek lub linka DT
preview_duties_other = Coś innego
preview_duties_none = Nieużywane
preview_naming_lead = Co porusza każde serwo i między którymi krokami. „W górę” i „w dół” dotyczą krawędzi spływu.
preview_naming_duty = { $servo } porusza
preview_naming_name = Nazwa tego, co porusza { $servo }
preview_naming_low = { $servo }, jeden koniec w krokach
preview_naming_high = { $servo }, drugi koniec w krokach
preview_naming_from = od
preview_naming_to = do
preview_naming_sense = { $servo }, co robi więcej kroków
preview_naming_otherSense_false = więcej kroków: w górę
preview_naming_otherSense_true = więcej kroków: w dół
preview_naming_rudderSense_false = więcej kroków: w prawo
preview_naming_rudderSense_true = więcej kroków: w lewo

## The sheet of a program.

print_paper = Papier
print_what = Na kartce
print_parts_lines = Linie do pisania
print_parts_code = Kod QR
print_nothing = Wybierz programy z biblioteki albo jakiś otwórz.
print_choose = Programy na tym wydruku: { $chosen }
print_clear = Usuń wszystkie
print_simulated = symulowany timer
print_warnings = Obejrzyj to przed lotem
print_notes = Notatki
print_codeHint = Aparat telefonu otwiera ten program, bez jego notatki.
print_unfinished =
    { $count ->
        [one] { $count } pole nie ma jeszcze wartości: wydrukowano ostatnią
        [few] { $count } pola nie mają jeszcze wartości: wydrukowano ostatnie
       *[many] { $count } pól nie ma jeszcze wartości: wydrukowano ostatnie
    }
print_printed = Wydrukowano { $date }

## The model in the strip.

recognition_which = Który model?
recognition_change = Model { $model }: wskaż, który to model

## A memory with the pilot's name for it: M2 “fly-off”.

memoryNames_named = { $memory } „{ $name }”

## What an earlier job left behind on a timer.

recovery_title = Wcześniejsze wgrywanie zostało przerwane.
recovery_when = Wgrywanie zaczęło się { $time }. Pamięć: { $memory }.
recovery_nothing =
    { $missing ->
        [one] Timer zawiera to, co przedtem: nic nie wgrano, brakuje { $missing } zmiany.
        [few] Timer zawiera to, co przedtem: nic nie wgrano, brakuje { $missing } zmian.
       *[many] Timer zawiera to, co przedtem: nic nie wgrano, brakuje { $missing } zmian.
    }
recovery_part =
    { $missing ->
        [one] Z tamtego wgrywania timer zawiera: { $values }; jak przedtem jest jeszcze { $missing } wartość.
        [few] Z tamtego wgrywania timer zawiera: { $values }; jak przedtem są jeszcze { $missing } wartości.
       *[many] Z tamtego wgrywania timer zawiera: { $values }; jak przedtem jest jeszcze { $missing } wartości.
    }
recovery_foreign =
    { $count ->
        [one] { $count } wartość w timerze nie pochodzi ani sprzed tamtego wgrywania, ani z niego. Czy to inny timer, czy zmieniło ją coś innego?
        [few] { $count } wartości w timerze nie pochodzą ani sprzed tamtego wgrywania, ani z niego. Czy to inny timer, czy zmieniło je coś innego?
       *[many] { $count } wartości w timerze nie pochodzi ani sprzed tamtego wgrywania, ani z niego. Czy to inny timer, czy zmieniło je coś innego?
    }
recovery_sure = Strona nie umie odróżnić timerów tego samego rodzaju. Idź dalej tylko wtedy, gdy to timer z tamtego wgrywania.
recovery_finish = Dokończ wgrywanie…
recovery_goBack = Wgraj dawne wartości…
recovery_leave = Zostaw, jak jest
recovery_otherTimer = To inny timer
recovery_sameTimer = To ten sam timer: pokaż, co miało być wgrane
recovery_compare = Porównaj
recovery_before = Przedtem
recovery_elsewhere = Wgrywanie do timera tego rodzaju zostało przerwane. Pamięć: { $memory }. Odczytaj ją, aby zobaczyć, co zawiera.
recovery_left = Praca strony na pamięciach została przerwana. Następny lot: teraz { $current }, przedtem { $original }.
recovery_mayFly = Możliwe, że na następny lot wybrana jest { $memory }: jej wybieranie zostało przerwane.
recovery_mayNotFly = Praca strony na pamięciach została przerwana. Możliwe, że na następny lot wybrana jest inna pamięć niż { $original }.
recovery_unknownMemory = nieznana pamięć

## The backups.

backups_title = Kopie zapasowe
backups_empty = Przed każdym wgrywaniem strona zachowuje tutaj to, co zawiera timer.
backups_reasons_write = przed wgrywaniem
backups_reasons_memories = wszystkie pamięci

## How the page looks.

theme_title = Kolory
theme_names_system = Systemowe
theme_names_light = Jasne
theme_names_dark = Ciemne
theme_names_sun = Słońce

## The settings of the page.

settings_look = Wygląd
settings_expert = Ekspert: pokaż linię
settings_expertHint = Linia pokazuje każdy bajt między tą stroną a timerem. W widoku „{ views_names_bench }” pojawia się skok, którego działanie nie jest opisane.
settings_kept = Co zachowuje to urządzenie

## A saved program as a link and a QR code, and back.

share_offer_lead = Link zawiera cały program. Nic nie jest wysyłane na serwer.
share_offer_link = Link
share_offer_copy = Kopiuj link
share_offer_scan = Skieruj aparat drugiego urządzenia na ten kod albo wyślij link.
share_offer_qr = Kod QR: „{ $name }”
share_offer_cut = Koniec notatki nie mieści się w kodzie QR. Link zawiera całą notatkę.
share_offer_tooLong = Za długie na kod QR. Wyślij link.
share_received_title = Program z linku
share_received_lead = Na razie strona tylko go pokazuje. Nic nie jest zachowywane ani wgrywane do timera.
share_received_known = Biblioteka ma już te wartości: { $name }.
share_received_modelChoice = Zachowaj pod
share_received_newModel = Nowy model „{ $name }”
share_received_keep = Zachowaj w bibliotece
share_received_discard = Nie zachowuj
share_received_unwritten = To, co wpisano, jest zachowane: „Cofnij” albo strona początkowa przywraca te zmiany.
share_damaged_title = Nie można odczytać tego linku.
share_damaged_bad = Jest ucięty, uszkodzony albo nie pochodzi z tej strony. Poproś o niego jeszcze raz.
share_paste_title = Wklej link…
share_paste_lead = Aparat telefonu sam otwiera kod QR. Tutaj możesz wkleić link.
share_paste_show = Pokaż
share_paste_notLink = To nie jest link do programu.

## A DT for trimming that is about to be flown. The page asks before the pilot disconnects, and at a contest round.

shortDt_held = { $memory }: DT to { $dt }.
shortDt_heldHere = DT to { $dt }.
shortDt_ask =
    { $remembered ->
        [true] Przywrócić { $back }?
       *[false] Ustawić { $back }?
    }
shortDt_putBack =
    { $remembered ->
        [true] Przywróć DT { $back }…
       *[false] Ustaw DT { $back }…
    }
shortDt_disconnect = Rozłącz tak: { $memory }, DT{"\u00a0"}{ $dt }
shortDt_disconnectHere = Rozłącz tak: DT{"\u00a0"}{ $dt }
shortDt_blocked = Czegoś z tego, co wpisano, nie da się jeszcze wgrać. Popraw to, zanim przywrócisz DT.
shortDt_settings_limit = DT jest krótkie poniżej
shortDt_settings_hint = Krótsze DT jest czerwone, a strona pyta, zanim się rozłączysz. Przy 0 s nigdy nie pyta.

## The start, before anything was read.

start_title = Ustaw swój timer Sidus
start_lead = Odczytaj, co zawiera, zmień to, wgraj i zobacz, że jest zweryfikowane. Nic nie opuszcza tego urządzenia.
start_adapter = Podłącz adapter
start_firefox = Firefox najpierw pyta o zgodę, a po każdym wczytaniu tej strony także o port.
start_android = Telefon łączy się przez Bluetooth; kabel wymaga Androida { firstVersions_androidCable } i Chrome { firstVersions_android }.
start_readyOffline = Gotowe offline
start_install = Zainstaluj
start_picture_example = Przykład: F1Q
start_picture_kept = Zachowano { $time }
start_models_title = Moje modele
start_models_none = Przechowuj programy każdego modelu, z notatkami.
start_models_programs =
    { $count ->
        [one] { $count } program
        [few] { $count } programy
       *[many] { $count } programów
    }
start_models_library = Otwórz bibliotekę
start_programs_title = Niedokończone
start_programs_made = { $timer }, nowy
start_programs_changesOf = { $timer }, zmiany
start_programs_sure = Usunąć na dobre?
start_simulatedTitle = Nie masz przy sobie timera?
start_simulatedLead = Symulowany odpowiada jak prawdziwy, bajt w bajt.
start_simulated = Wypróbuj symulowany timer { $name }
start_backups =
    { $count ->
        [one] { $count } kopia zapasowa sprzed wgrywania. Ostatnia: { $last }.
        [few] { $count } kopie zapasowe sprzed wgrywania. Ostatnia: { $last }.
       *[many] { $count } kopii zapasowych sprzed wgrywania. Ostatnia: { $last }.
    }

## The dialog that makes a program without a timer.

newProgram_title = Nowy program…
newProgram_timerClass = Klasa
newProgram_functions = Funkcje, bez startu i DT
newProgram_servos = Serwa
newProgram_from = Na początek
newProgram_beginnings_usual = Zwykłe czasy, serwa w środku
newProgram_beginnings_nothing = Wszystkie czasy i pozycje 0
newProgram_caution = Pozycje twojego modelu nie są tu znane. Ustaw każdą z nich przed wgraniem.
newProgram_make = Utwórz program

## The picture of a program over time.

timeline_title = Oś czasu
timeline_compareBefore = przed podążaniem
timeline_picture = Pozycje serw w czasie
timeline_description = { $servos } i { $functions } w czasie, DT: { $dt }. Tabela zawiera wszystkie wartości.
timeline_descriptionMotor = { $servos } i { $functions } w czasie, DT: { $dt }, stop silnika: { $motorStop }. Tabela zawiera wszystkie wartości.
timeline_functions =
    { $count ->
        [one] { $count } funkcja
        [few] { $count } funkcje
       *[many] { $count } funkcji
    }
timeline_servos =
    { $count ->
        [one] { $count } serwo
        [few] { $count } serwa
       *[many] { $count } serw
    }
timeline_keysToEdit = Strzałki prowadzą od znaku do znaku i od serwa do serwa, plus i minus zmieniają powiększenie, 0 pokazuje wszystko. Enter prowadzi do uchwytów: strzałki je przesuwają, Escape wraca.
timeline_ask = Wskaż lub dotknij, aby odczytać
timeline_finer = Dokładniej
timeline_steps =
    { $position ->
        [one] { $position } krok
        [few] { $position } kroki
       *[many] { $position } kroków
    }
timeline_stepsUnit = kroków
timeline_notKnown = Nieznane: czasy maleją
timeline_tools = Widok
timeline_zoomIn = Powiększ
timeline_zoomOut = Pomniejsz
timeline_fit = Pokaż wszystko
timeline_passedOver = Pomijane: { $slot }, bo { $next } wypada w tym samym czasie.
timeline_goesBack = { $next } wypada wcześniej niż { $slot }. Nie wiadomo, co timer robi w zacieniowanej części.

## A new version of the page.

update_ready = Gotowa jest nowa wersja.
update_waits = Uruchomi się, gdy się rozłączysz i nic nie będzie otwarte ani niezapisane.
update_take = Użyj teraz
update_news = Co nowego

## The version of this page.

aboutPage_title = Ta strona
aboutPage_version = Sidus Timer { $version }.
aboutPage_offline = Cała strona jest na tym urządzeniu: działa bez sieci.
aboutPage_notOffline = Strona nie jest jeszcze zachowana na tym urządzeniu: otwórz ją raz z siecią.
aboutPage_licences = Licencje

## The views of the page and the links between them.

views_title = Widoki
views_names_program = Program
views_names_memories = Pamięci
views_names_bench = Próby
views_names_library = Biblioteka
views_names_line = Linia
views_names_settings = Ustawienia
views_names_print = Druk
views_names_help = Pomoc
views_print = Drukuj…
views_share = Udostępnij…
views_noTimer_memories = Połącz timer, aby zobaczyć jego pamięci. Kopie zapasowe są poniżej.
views_noTimer_bench = Połącz timer, aby poruszać jego serwami.

## The strip above every view: the timer, its memory, DT, motor stop, and what is known.

strip_panel = Pamięci i reszta
strip_tried = próbne: { $count }
strip_notCertain = niepewne
strip_asRead = ost. odczyt
strip_notValid = błędne
strip_ofSetting =
    { $changes ->
        [0] zapisany
       *[other] bez zapisu: { $changes }
    }
strip_made = nie w timerze

## The list of commands.

palette_title = Polecenia
palette_search = Wpisz, co chcesz zrobić
palette_nothing = Żadne polecenie tak się nie nazywa albo teraz nie da się go wykonać.
palette_ctrl = Ctrl+{ $key }

## In place of a part of the page that is being loaded.

parts_coming = Wczytywanie
parts_failed = Nie udało się wczytać części tej strony.
parts_again = Spróbuj ponownie

## Which model it is.

whichModel_recognition_same = To { $model }, zawartość jak przy odczycie { $when }.
whichModel_recognition_like =
    { $count ->
        [one] To przypomina model { $model }, różni się { $count } wartość. Czy to { $model }?
        [few] To przypomina model { $model }, różnią się { $count } wartości. Czy to { $model }?
       *[many] To przypomina model { $model }, różni się { $count } wartości. Czy to { $model }?
    }
whichModel_recognition_several = To może być { $models }. Który to model?
whichModel_or = { $names } lub { $last }
whichModel_others = jeden z { $count } innych
whichModel_recognition_unknown = Ten timer nie jest tu znany. Który to model?
whichModel_recognition_yes = Tak, { $model }
whichModel_recognition_choose = Wybierz…
whichModel_recognition_ok = OK
whichModel_recognition_dialog_title = Który to model?
whichModel_recognition_dialog_lead = Timer nie zna swojego modelu. Strona porównuje jego zawartość z tym, co ostatnio widziała w każdym modelu.
whichModel_recognition_dialog_said = Wskazany model: { $model }.
whichModel_recognition_dialog_moreMemories = Odczytaj także inne pamięci: mogą pomóc odróżnić modele.
whichModel_recognition_dialog_none = Nie ma takiego modelu tej klasy.
whichModel_recognition_dialog_newModel = Nowy model
whichModel_recognition_dialog_keep = Zachowaj jako nowy model
whichModel_memoryNames_label = Nazwa pamięci { $memory }
whichModel_memoryNames_give = Nazwij
whichModel_crossing_title = To wartości modelu { $from }, ale ten timer wygląda na timer modelu { $to }.
whichModel_crossing_advice = Z wartościami innego modelu możesz ten model stracić. Spójrz na model, który masz przed sobą.
whichModel_crossing_confirm = Wgraj wartości modelu { $from } do timera modelu { $to }.
whichModel_crossing_memoryOf = { $memory } ({ $model })

## A write, from the difference to the verdict.

write_title = Wgraj do timera
write_lead = Oto, co się zmieni. Pamięć: { $memory }. Wszystko inne pozostaje bez zmian.
write_target = Wgraj do
write_nothing = Nic się nie różni. Timer zostanie odczytany kontrolnie i porównany.
write_field = Wartość
write_from = W timerze
write_to = Będzie
write_wasRead = Poprzedni odczyt
write_moved_model_title = Ten timer wydaje się teraz należeć do innego modelu.
write_moved_model_advice = Nic nie wgrano. Spójrz na nazwy modeli.
write_moved_edits_title = Program zmienił się, odkąd to pokazano.
write_unkept_title = Nie udało się zachować na tym urządzeniu kopii zapasowej tego, co timer zawiera teraz.
write_unkept_advice = Ta pamięć jest nadal jak przedtem. Dalej bez kopii zapasowej?
write_sideBySide = Wartości: { $names }
write_withoutCopy = Dalej bez kopii zapasowej
write_safety = Śmigło jest zdjęte albo model jest trzymany, a timer nie jest uzbrojony.
write_acknowledge = Przeczytane, mimo to chcę wgrać.
write_stillToTick = Do zaznaczenia: { $ticks }.
write_ticks_model = inny model
write_ticks_warnings = ostrzeżenia
write_ticks_safety = śmigło
write_move_why = Ten timer wydaje się zachowywać pozycje tylko tam, gdzie stoją jego serwa. Jeśli serwa się nie poruszą, prawdopodobnie tych pozycji nie zachowa.
write_move_label = Przestaw serwa na każdą funkcję, zanim jej pozycje zostaną zapamiętane w timerze.
write_move_hint = Trzymaj pewnie model, nic nie może przeszkadzać serwom.
write_move_notHeld_title = Timer potwierdził pozycje, ale ich nie zachował.
write_move_notHeld_advice = Ten timer prawdopodobnie zachowuje je tylko tam, gdzie stoją jego serwa. Wgraj ponownie i pozwól serwom przestawiać się na każdą funkcję.
write_move_again = Wgraj ponownie…
write_start =
    { $count ->
        [0] Odczytaj kontrolnie i porównaj
        [one] Wgraj { $count } zmianę
        [few] Wgraj { $count } zmiany
       *[many] Wgraj { $count } zmian
    }
write_stages_read = Odczyt
write_stages_write = Wgrywanie
write_stages_verify = Odczyt kontrolny
write_stages_repair = Poprawianie
write_stopping = Zatrzymanie po tym zapytaniu
write_stoppingBack = Zatrzymywanie: najpierw powrót do poprzedniej pamięci
write_verified_title = Zweryfikowano.
write_verified_advice = Timer odczytano kontrolnie i zawiera to, co pokazano.
write_verdict = { $memory }: zweryfikowano { $time }
write_asItIs = bez zmian
write_insteadOf = zamiast { $value }
write_wanted = Do wgrania
write_readBack = Odczyt kontrolny
write_differs_title = Timer nie przyjął wszystkich wartości.
write_differs_advice = Timer odczytano kontrolnie. Tutaj zawiera inne wartości:
write_unknown_title = Nie jest pewne, co zawiera timer.
write_unknown_advice = Nie udało się odczytać timera kontrolnie w całości. Odczytaj ponownie, potem wgraj to, co się jeszcze różni. Twoje zmiany są zachowane.
write_cut = Wgrywanie zostało przerwane. Pamięć: { $memory }.
write_strayed_title = Podczas wgrywania bieżąca stała się inna pamięć: { $memory }.
write_strayed_advice = Część wartości może być teraz w pamięci { $memory }. Odczytaj ją i obejrzyj całą, zanim z nią polecisz.
write_refused = Nic nie wgrano.
write_status_differs = inna
write_status_unknown = nieznane
write_putBack = zmieniła się sama, przywrócona

## What the parts of the page that are loaded first say.

name = Sidus Timer
classNames_Q = F1Q
classNames_B = F1B
classNames_E = F1E
unknownClass = Klasa { $letter }
memoryName = M{ $number }
servoName = S{ $number }
slotName =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] Funkcja { $slot }
    }
within_slot =
    { $kind ->
        [start] start
        [dt] DT
       *[function] funkcja { $slot }
    }
within_idleThrottle = wolne obroty
slotShort =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] { $slot }
    }
about = { $name }:
previous = Wstecz
next = Dalej
pause = Pauza
less = { $what }: mniej
moreOf = { $what }: więcej
seconds = { $time }{" "}s
times_minutes = { $minutes }{" "}min
times_minutesSeconds = { $minutes }{" "}min { $seconds }{" "}s
times_units_s = s
times_units_min = min
times_figure = { $text } { $unit }
times_asSeconds = { $seconds }{" "}s, { $clock }
times_meaning = { $field }: co znaczy wpisany tekst
header_firmware = firmware { $firmware }
header_simulated = symulowany
header_connect = Połącz
header_choosePort = Wybierz inny adapter
header_closeProgram = Zamknij program
header_disconnect = Rozłącz
header_stop = Stop
program_tableCaption = Czas i pozycje serw każdej funkcji
program_slot = Funkcja
program_time = Czas
program_memory = Pamięć
program_memoryUnknown = Ten timer nie podaje, która pamięć jest bieżąca, więc nie wiadomo, która jest wybrana na następny lot.
program_memoryOpen = Nie wiadomo, która pamięć jest wybrana na następny lot. Wybierz jedną na następny lot albo odczytaj ponownie.
program_dt = DT
program_motorStop = Stop silnika
program_motor = Silnik
program_idleThrottle = Wolne obroty
program_throttle = Wolne obr.
program_idleThrottleUnit = jednostka nieznana
program_reserved = zarezerwowane { $time }
program_timeOf = { $slot }, czas
program_motorStopTime = Stop silnika, czas
program_positionOf = { $slot }, { $servo }
program_shortDt = Krótkie DT
program_changes =
    { $count ->
        [one] { $count } zmiana
        [few] { $count } zmiany
       *[many] { $count } zmian
    }
program_undoAll = Cofnij wszystko
program_read = Ponów odczyt
program_connectAndWrite = Połącz i wgraj…
program_write =
    { $count ->
        [0] Wgraj…
        [one] Wgraj { $count } zmianę…
        [few] Wgraj { $count } zmiany…
       *[many] Wgraj { $count } zmian…
    }
program_picture = Obraz
program_table = Tabela
program_blocked = Na razie nic nie można wgrać. { $field }: { $why }
program_findings = Kontrola
program_noFindings = Nic nietypowego.
program_absolute = Czasy pokazano, licząc od startu. Nie wiadomo, czy ten timer liczy od startu, czy od poprzedniej funkcji.
program_severity_error = Nie do wgrania
program_severity_serious = Poważne
program_severity_warning = Nietypowe
program_reading = Odczyt timera
program_selecting = Zmiana pamięci
otherTab_holdsSince = Sidus Timer jest otwarty w innej karcie, od { $since }.
otherTab_holds = Sidus Timer jest otwarty w innej karcie.
otherTab_takeOver = Użyj tutaj
otherTab_busy = Tamta karta pracuje z timerem. Strona otworzy się tutaj, gdy tylko skończy.
otherTab_gone = Tamta karta nie odpowiada. Zamknij ją, potem wczytaj tę stronę ponownie.
disturbed = Odpowiedzi brakuje albo są uszkodzone: czy timer nie śpi, a głowica podczerwieni jest blisko i nie w słońcu? To skończy się najpóźniej za { $seconds } s.
cancel = Anuluj
close = Zamknij
copy = Kopiuj
copied = Skopiowano.
copyByHand = Przeglądarka nie pozwala tej stronie kopiować. Skopiuj stąd.
dismiss = Ukryj
done = Gotowe
undo = Cofnij
open = Otwórz
save = Zapisz
delete = Usuń
notNow = Nie teraz
label_language = Język
label_name = Nazwa
label_note = Notatka
label_model = Model
label_search = Szukaj
noModel = Bez modelu
more = I jeszcze { $count }.
showMore = Pokaż jeszcze { $count }
of = { $button }: { $name }
notFitting = Nie pasuje do połączonego timera. Rozłącz, aby to otworzyć.
notKept = Ta przeglądarka tego nie zachowała: przepadnie, gdy strona zostanie zamknięta.

## The walk through the open questions of docs/protocol.md with a real timer.

settle_title = Rozstrzygnij to na swoim timerze
settle_lead = Nie wszystko wiadomo o tym, jak te timery się porozumiewają. W kwadrans twój rozstrzyga to, co otwarte. Po każdej próbie przywracana jest dawna wartość. Miej pod ręką programator ręczny.
settle_safe = Śmigło jest zdjęte albo silnik odłączony, a timer nie jest uzbrojony.
settle_danger = Teraz coś może się poruszyć. Czy śmigło jest zdjęte albo silnik odłączony? Spójrz jeszcze raz.
settle_blocked = Najpierw załatw to, o czym mówi kolorowy pasek u góry, i zachowaj to, co wypróbowano, albo przywróć to, co było przedtem.
settle_readIt = Odczytaj timer
settle_which = Co pokazuje programator?
settle_tryHint = Przestaw serwa przyciskami strony i poczekaj, aż staną. Potem wypróbuj pozycję: zostanie zmieniona i w ciągu kilku sekund przywrócona. Patrz na serwa.
settle_tryIt = Wypróbuj pozycję
settle_moved = Dawna pozycja jest z powrotem w timerze: strona ją odczytała. Czy podczas próby nowej poruszyło się któreś serwo?
settle_ask = Zapytaj z czterema zerami
settle_unknown = Nie wiem
settle_send = Wyślij plik przez ten formularz
settle_names_order = Młodszy bajt czasu jest pierwszy
settle_names_unit = Czasy są w setnych sekundy
settle_names_count = Czasy liczą się od startu
settle_names_memories = Pierwsza pamięć ma numer 0
settle_names_zeros = Wystarczą cztery zera
settle_names_layout = Funkcja jest przed serwem
settle_names_stores = Pozycje są zachowywane przy każdej funkcji
settle_names_moves = Wgrana pozycja porusza swoje serwo
settle_names_unlock = Litera odpowiedzi na UNLOCK
settle_names_delay = Zwykły czas odpowiedzi
settle_names_reserved = Zarezerwowany czas, jak odczytano
settle_yes = Tak
settle_no = Nie
settle_unnumbered = Numeru nie podano
settle_there = Tylko tam, gdzie stoją serwa
settle_delay = { $ms } ms
settle_open = Nierozstrzygnięte
